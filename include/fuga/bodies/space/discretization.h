// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_space_discretization_h
#define fuga_bodies_space_discretization_h

#include <deal.II/base/numbers.h>

#include <fuga/bodies/model_definition.h>
#include <fuga/bodies/space/hanging_nodes.h>
#include <fuga/bodies/space/reference_element.h>
#include <fuga/mesh/joint_splitter.h>

#include <set>

namespace dealii
{
  template <int dim, int spacedim>
  class Triangulation;
  template <int dim, int spacedim>
  class DoFHandler;
} // namespace dealii

namespace fuga
{
  /**
   * The finite element space on the open mesh: deal.II's triangulation and degrees of freedom, of
   * which every process of a run has its part (make_triangulation()), and flat tables of *nodes* (a
   * node carries one degree of freedom per direction) with which the rest of this layer works. The
   * tables are complete and identical on all processes, numbered as in a run of one: cells by their
   * path from the coarse mesh (CellId), nodes by the first cell that has them. A process computes
   * on the cells that it owns.
   */
  template <int dim>
  class Discretization
  {
  public:
    static constexpr unsigned int no_node = static_cast<unsigned int>(-1);
    static constexpr unsigned int no_cell = static_cast<unsigned int>(-1);

    struct BoundaryFace
    {
      unsigned int cell   = 0;
      unsigned int number = 0;
      /** Label of the face; JointedMesh::no_label for a face without group. */
      unsigned int label = 0;
    };

    /**
     * Create the space. The tables contain the bodies that exist in @p stage; deal.II's objects
     * contain all.
     * @throws InputError for mixed or degenerate cells, for elements that do not exist, for a mesh
     * of another dimension, and for points beyond the axis of an axisymmetric model.
     */
    Discretization(const JointedMesh &mesh,
                   const ModelDefinition &model,
                   const unsigned int stage = 0);

    ~Discretization();

    const dealii::Triangulation<dim, dim> &
    triangulation() const
    {
      return *mesh;
    }

    const dealii::DoFHandler<dim, dim> &
    dof_handler() const
    {
      return *dofs;
    }

    const dealii::Mapping<dim, dim> &
    mapping() const
    {
      return reference.mapping();
    }

    const ReferenceElement<dim> &
    reference_element() const
    {
      return reference;
    }

    std::size_t
    n_cells() const
    {
      return bodies.size();
    }

    /**
     * Return the number in the tables of the cell with deal.II's @p active_cell_index; no_cell for
     * bodies that do not exist and for cells of other processes.
     */
    unsigned int
    cell_number(const unsigned int active_cell_index) const
    {
      return cell_numbers[active_cell_index];
    }

    /** Return the process that computes on a cell. */
    unsigned int
    owner(const std::size_t cell) const
    {
      return owners.empty() ? 0 : owners[cell];
    }

    /** Return whether this process computes on a cell. */
    bool
    is_own(const std::size_t cell) const
    {
      return owner(cell) == my_rank;
    }

    std::size_t
    n_own_cells() const;

    /** Return whether this process keeps only its part of deal.II's mesh. */
    bool
    is_divided_by_p4est() const;

    std::size_t
    n_nodes() const
    {
      return positions.size();
    }

    std::size_t
    n_dofs() const
    {
      return dim * n_nodes();
    }

    /** Return the nodes of a cell (in the order of active cells); its corners come first. */
    const unsigned int *
    cell_nodes(const std::size_t cell) const
    {
      return nodes_of_cells.data() + cell * reference.n_nodes();
    }

    /** Return the body of a cell as an index into JointedMesh::body_names. */
    unsigned int
    cell_body(const std::size_t cell) const
    {
      return bodies[cell];
    }

    /**
     * Return the number of the degree of freedom of a node in one direction, in a model with all
     * bodies.
     */
    unsigned int
    dof(const std::size_t node, const unsigned int component) const
    {
      return (numbers_of_nodes.empty() ? static_cast<unsigned int>(node) : numbers_of_nodes[node]) *
               dim +
             component;
    }

    /** Return the number of degrees of freedom of the model with all bodies. */
    unsigned int
    n_dofs_of_all_bodies() const;

    /**
     * Return the entries of the nodes, node * dim + component, of a vector with an entry for each
     * of these degrees of freedom, by dof().
     */
    template <typename VectorType>
    Vector
    by_nodes(const VectorType &of_all) const
    {
      Vector result(n_dofs());
      for (std::size_t node = 0; node < n_nodes(); ++node)
        for (unsigned int c = 0; c < dim; ++c)
          result[node * dim + c] = of_all[dof(node, c)];
      return result;
    }

    const dealii::Point<dim> &
    position(const std::size_t node) const
    {
      return positions[node];
    }

    bool
    is_axisymmetric() const
    {
      return axisymmetric;
    }

    /**
     * Return the factor by which lengths in the plane have to be multiplied to become areas: the
     * thickness, or the circumference 2πr.
     */
    double
    extent_across(const dealii::Point<dim> &point) const
    {
      return axisymmetric ? 2. * dealii::numbers::PI * point[0] : thickness;
    }

    /** Return whether a node lies on the axis of revolution, i.e. exactly at x = 0. */
    bool
    is_on_axis(const std::size_t node) const
    {
      return axisymmetric && positions[node][0] == 0.;
    }

    /** Return the node at a vertex of the JointedMesh; no_node for a vertex that no cell uses. */
    unsigned int
    node_at_vertex(const unsigned int vertex) const
    {
      return vertex_nodes.at(vertex);
    }

    /** Return for each body whether it exists. */
    const std::vector<bool> &
    bodies_there() const
    {
      return there;
    }

    bool
    is_complete() const
    {
      return numbers_of_nodes.empty();
    }

    /** Return whether faces with this label belong to bodies that do not exist. */
    bool
    lacks_faces_of(const unsigned int label) const
    {
      return absent_labels.count(label) > 0;
    }

    /**
     * Return the hanging nodes: none if the mesh is not refined locally, and never on a lip in 2D.
     */
    const HangingNodes<dim> &
    hanging_nodes() const
    {
      return hanging;
    }

    const std::vector<BoundaryFace> &
    boundary_faces() const
    {
      return outer_faces;
    }

    /** Return the boundary faces whose label is @p marked, see fuga::selection(). */
    std::vector<BoundaryFace>
    boundary_faces(const std::vector<bool> &marked) const;

    /** Return node @p k of a boundary face, in the order of ReferenceElement::Face. */
    unsigned int
    face_node(const BoundaryFace &face, const std::size_t k) const
    {
      return cell_nodes(face.cell)[reference.face(face.number).nodes[k]];
    }

    /**
     * Return the distance of the first and last nodes of a face; in space this is an edge or a
     * diagonal.
     */
    double
    face_length(const BoundaryFace &face) const;

    /** Return the mean of the corners of a face. */
    dealii::Point<dim>
    face_center(const BoundaryFace &face) const;

    /**
     * Return the number of the piece of the mesh to which a cell belongs; cells of one piece are
     * connected through faces.
     */
    unsigned int
    cell_piece(const std::size_t cell) const
    {
      return pieces[cell];
    }

    unsigned int
    n_pieces() const
    {
      return piece_count;
    }

  private:
    struct Gathered;

    void
    make_tables();

    Gathered
    gather_cells();

    void
    number_nodes(const Gathered &gathered);

    void
    find_positions(const std::vector<unsigned int> &node_of_dof);

    void
    find_boundary_faces();

    void
    find_pieces(const Gathered &gathered);

    bool axisymmetric;
    double thickness;
    ReferenceElement<dim> reference;
    std::unique_ptr<dealii::Triangulation<dim, dim>> mesh;
    std::unique_ptr<dealii::FiniteElement<dim, dim>> element;
    std::unique_ptr<dealii::DoFHandler<dim, dim>> dofs;

    const std::vector<bool> there;
    std::vector<unsigned int> cell_numbers;
    std::set<unsigned int> absent_labels;
    std::vector<unsigned int> nodes_of_cells;
    std::vector<unsigned int> bodies;
    /** The process that computes on each cell; empty if there is only one. */
    std::vector<unsigned int> owners;
    unsigned int my_rank = 0;
    std::vector<unsigned int> pieces;
    unsigned int piece_count = 0;
    /** Numbers of the nodes in a model with all bodies; empty if this is one. */
    std::vector<unsigned int> numbers_of_nodes;
    HangingNodes<dim> hanging;
    std::vector<dealii::Point<dim>> positions;
    std::vector<unsigned int> vertex_nodes;
    std::vector<BoundaryFace> outer_faces;
  };
} // namespace fuga

#endif
