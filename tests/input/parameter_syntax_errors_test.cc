// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_wrong_input.h"

#include <unistd.h>

#include <filesystem>

namespace fuga
{
  namespace
  {
    using testing_files::expect_explained;
    using testing_files::name_of;
    using testing_files::WrongInput;

    class WrongSyntax : public testing::TestWithParam<WrongInput>
    {
    };

    TEST_P(WrongSyntax, AreExplained)
    {
      expect_explained(GetParam());
    }

    const WrongInput syntax[] = {
      {"MissingEnd",
       {{"set Fields = end\nend\n", "set Fields = end\n"}},
       {},
       {".prm:83", "'Output' is never closed", "missing 'end'"}},
      {"ManyMissingEnds",
       {{"subsection Mesh",
         "subsection a\nsubsection b\nsubsection c\nsubsection d\nsubsection e\nsubsection "
         "f\nsubsection Mesh"}},
       {},
       {".prm:10", "'a/b/c/d/e/f' lies 6 sections deep", "not closed"}},
      {"SurplusEnd",
       {{"subsection Mesh", "end\nsubsection Mesh"}},
       {},
       {".prm:5", "'end' without a subsection"}},
      {"TextBehindEnd",
       {{"end\nsubsection Mesh", "end Constants\nsubsection Mesh"}},
       {},
       {".prm:4", "'Constants'"}},
      {"TextOutsideOfSet",
       {{"set Title = An example", "Title = An example"}},
       {},
       {".prm:1", "'Title = An example'", "Write 'set'"}},
      {"MissingEquals",
       {{"set Title = An", "set Title An"}},
       {},
       {".prm:1", "has no '='", "set NAME = VALUE"}},
      {"MissingName", {{"set Title =", "set ="}}, {}, {".prm:1", "no name before the '='"}},
      {"SubsectionWithoutName",
       {{"subsection Mesh", "subsection"}},
       {},
       {".prm:5", "without a name"}},
      {"Include",
       {{"set Title = An example", "include other.prm"}},
       {},
       {".prm:1", "cannot be included"}},
      {"BackslashAtEnd",
       {{"set Fields = end\nend\n", "set Fields = end\nend\\\n"}},
       {},
       {".prm:85", "backslash"}},
      {"MissingMeshFile",
       {{"example.msh", "nowhere.msh"}},
       {},
       {".prm:6", "Mesh/File = 'nowhere.msh'", "does not exist", "relative to the folder"}},
      {"WrongMeshExtension", {{"example.msh", "example.inp"}}, {}, {".prm:6", "ends in .msh"}},
      {"OverrideWithoutEquals",
       {},
       {"Mesh/Refinements"},
       {"--set \"Mesh/Refinements\"", "Section/Sub/Entry=value"}},
      {"OverrideOfUnknownSection", {}, {"Mash/File=a"}, {"--set \"Mash/File=a\"", "'Mesh'?"}},
      {"OverrideOfUnknownSubsection",
       {},
       {"Joints/bse/Cohesion=1"},
       {"--set", "no subsection 'bse'", "Did you mean 'base'?"}},
      {"OverrideOfUnknownEntry", {}, {"Mesh/Fil=a.msh"}, {"--set \"Mesh/Fil=a.msh\"", "'File'?"}},
      {"OverrideOutOfRange",
       {},
       {"Mesh/Refinements=-1"},
       {"--set", "Refinements = '-1'", "from 0 to 8"}},
      {"OverrideTwice",
       {},
       {"Mesh/Refinements=1", "Mesh/Refinements=2"},
       {"--set \"Mesh/Refinements=2\"", "already set by --set \"Mesh/Refinements=1\""}},
      {"OverrideRemovesNothing", {}, {"Mesh/Refinements="}, {"not set in", "Give a value"}},
      {"OverrideOfPair",
       {},
       {"Joints/base/Normal stiffness=1"},
       {".prm:28", "'Normal stiffness' is given as well", "--set"}},
    };
    INSTANTIATE_TEST_SUITE_P(Syntax, WrongSyntax, testing::ValuesIn(syntax), name_of);
  } // namespace

  using testing_files::example_prm;
  using testing_files::expect_parts;
  using testing_files::message_of;
  using testing_files::write_file;

  TEST(WrongFiles, AreExplained)
  {
    expect_parts(message_of("nowhere/to_be_found.prm"),
                 {"nowhere/to_be_found.prm", "does not exist"});
    expect_parts(message_of(testing::TempDir()), {"is a directory", ".prm or .json"});
    expect_parts(message_of(write_file("empty.prm", "\n  \n")),
                 {"empty.prm", "empty", "--print-parameters"});
    expect_parts(message_of(write_file("zero.json", "")), {"zero.json", "is empty"});
    expect_parts(message_of(write_file("a.txt", example_prm())),
                 {"a.txt", "'.txt'", ".prm or .json"});
    expect_parts(message_of(write_file("binary.prm", std::string("set a\0b", 7))), {"binary data"});
    expect_parts(
      message_of(write_file("bodies.prm", "subsection Mesh\nset File = example.msh\nend\n")),
      {"bodies.prm", "no bodies", "section Bodies"});
    expect_parts(message_of(write_file("comment.prm", "# nothing\n")), {"Mesh/File is missing"});
  }

  // Start and end of a message tell where and what to do; what is quoted between may be anything.
  TEST(WrongFiles, LongNamesAreShortened)
  {
    const std::string message =
      message_of(write_file("long.prm", "subsection " + std::string(200'000, 'a') + '\n'));
    EXPECT_LT(message.size(), 4000);
    expect_parts(message, {"long.prm:1", "aaa [...] aaa", "never closed. Add the missing 'end'."});
  }

  TEST(WrongFiles, WithoutStages)
  {
    const std::string text = example_prm();
    const std::string file =
      write_file("stages.prm", text.substr(0, text.find("subsection Loads")));
    expect_parts(message_of(file), {"stages.prm", "no stages", "section Stages"});
  }

  TEST(WrongFiles, CannotBeRead)
  {
    if (geteuid() == 0)
      GTEST_SKIP() << "root reads everything";
    const std::string file = write_file("secret.prm", example_prm());
    std::filesystem::permissions(file, std::filesystem::perms::none);
    expect_parts(message_of(file), {"secret.prm", "cannot be read", "permissions"});
  }

  TEST(WrongFiles, Json)
  {
    const auto message = [](const std::string &name, const std::string &text) {
      return message_of(write_file(name + ".json", text));
    };
    expect_parts(message("syntax", "{\n\"Title\": \"a\",\n\"Mesh\" {\n}}\n"),
                 {"syntax.json:3", "JSON syntax error", "expected ':'"});
    expect_parts(message("truncated", "{\"Mesh\": {"), {"truncated.json:1", "JSON syntax error"});
    expect_parts(message("duplicate", "{\n\"Title\": \"a\",\n\"Title\": \"b\"\n}"),
                 {"duplicate.json:3", "already set", "duplicate.json:2"});
    expect_parts(message("unknown", "{\n\"Mesh\": {\n\"Fil\": \"a\"}}"),
                 {"unknown.json:3", "Mesh/Fil = 'a'", "'File'?"});
    expect_parts(message("array", "{\n\"Mesh\": {\n\"File\": [1]}}"),
                 {"array.json:3", "Mesh/File", "array", "one string"});
    expect_parts(message("null", "{\n\"Title\": null}"), {"null.json:2", "Title", "null"});
    expect_parts(message("list", "[1]"), {"list.json:1", "must be one object"});
    expect_parts(message("number", "3"), {"number.json:1", "must be one object"});
    expect_parts(message("overflow", "{\"Dimension\": 1e999}"),
                 {"overflow.json:1", "JSON", "1e999"});
    expect_parts(message("range", "{\n\n\"Dimension\": -2}"),
                 {"range.json:3", "Dimension = '-2'", "out of range"});
    expect_parts(message("fraction", "{\"Dimension\": 2.5}"), {"'2.5'", "not an integer"});
    expect_parts(message("value", "{\"Mesh\": 3}"), {"value.json:1", "Mesh"});
  }
} // namespace fuga
