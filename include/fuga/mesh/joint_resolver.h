// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_mesh_joint_resolver_h
#define fuga_mesh_joint_resolver_h

#include <fuga/mesh/face_table.h>
#include <fuga/mesh/joint_splitter.h>

#include <array>
#include <string>
#include <vector>

namespace fuga
{
  /** The faces of the mesh to which the named groups were resolved. */
  struct ResolvedFaces
  {
    /** A face inside the mesh along which a joint opens it, given by its two half-faces. */
    struct Opening
    {
      unsigned int plus  = 0;
      unsigned int minus = 0;
    };

    struct Outer
    {
      unsigned int half_face = 0;
      /** Index into group_names. */
      unsigned int group = 0;
    };

    /** The openings of each joint; empty if its mesh is already open. */
    std::vector<std::vector<Opening>> openings;
    std::vector<Outer> outer;
    /** Groups on the outer boundary, in the order of their tags. */
    std::vector<std::string> group_names;
  };

  /**
   * Finds the faces of every named group and checks the joints against them, so that nothing has to
   * be guessed when the mesh is opened. All complaints are InputErrors.
   */
  class JointResolver
  {
  public:
    JointResolver(const GmshMesh &gmsh,
                  const JointedMesh &jointed,
                  const FaceTable &faces,
                  const std::vector<JointDefinition> &definitions);

    ResolvedFaces
    run();

  private:
    struct Group
    {
      std::string name;
      /** Half-faces (one of two for an inner face) and their vertices as they are drawn. */
      std::vector<unsigned int> half_faces;
      std::vector<std::array<unsigned int, 4>> drawn;
      /** Joint that opens along the group, or FaceTable::none. */
      unsigned int joint = FaceTable::none;
    };

    void
    collect_groups();
    void
    check_definition(const JointDefinition &definition) const;
    void
    check_names_differ() const;
    void
    check_body(const JointDefinition &definition, const std::string &body) const;
    /** Find the faces that joint @p j opens, or that are its lips. */
    void
    claim(const unsigned int j, std::vector<ResolvedFaces::Opening> &openings);

    void
    claim_line(const unsigned int joint);
    void
    claim_lip(const JointDefinition &definition, const std::string &lip, const std::string &body);
    void
    check_lengths(const JointDefinition &definition) const;
    Group &
    group(const JointDefinition &definition, const std::string &name);
    double
    measure(const std::string &group_name) const;
    ResolvedFaces::Opening
    opening(const JointDefinition &definition, const Group &line, const std::size_t face) const;
    void
    check_direction(const JointDefinition &definition, const Group &line) const;
    std::array<unsigned int, 4>
    vertices_of(const unsigned int half_face) const;
    const std::string &
    body_of(const unsigned int half_face) const;
    std::string
    centre_of(const unsigned int half_face) const;
    [[noreturn]] void
    fail(const JointDefinition &definition, const std::string &message) const;

    const GmshMesh &mesh;
    const JointedMesh &open_mesh;
    const FaceTable &table;
    const std::vector<JointDefinition> &joints;
    std::vector<Group> groups;
    std::vector<std::string> lips;
  };
} // namespace fuga

#endif
