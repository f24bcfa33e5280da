// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_test_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace fuga
{
  namespace testing_files
  {
    std::string
    write_file(const std::string &name, const std::string &text)
    {
      namespace fs = std::filesystem;
      // One folder per process: tests may run side by side.
      const fs::path file =
        fs::path(testing::TempDir()) / ("fuga_" + std::to_string(getpid())) / name;
      fs::create_directories(file.parent_path());
      std::ofstream(file.parent_path() / "example.msh") << "";
      std::ofstream(file, std::ios::binary) << text;
      return file.string();
    }


    const std::string &
    example_prm()
    {
      static const std::string text = R"(set Title = An example
subsection Constants
  set q = 0.0144
end
subsection Mesh
  set File              = example.msh
  set Polynomial degree = 2
  set Assumption        = plane stress
  set Thickness         = 0.5
end
subsection Bodies
  subsection dam
    set Young modulus  = 3060
    set Poisson ratio  = 0.2
    set Weight density = 0.024
  end
  subsection rock
    set Young modulus = 30600
    set Poisson ratio = 0.25
  end
end
subsection Joints
  subsection base
    set Line       = base
    set Plus body  = dam
    set Minus body = rock
    set Normal law = cubic root
    set Normal compliance = 1.25e-4
    set Shear stiffness = 8000
    set Thickness = 0.002
    set Friction coefficient = 0.2
    set Initial gap = 0.001*x
  end
  subsection wall
    set Plus lip  = wall
    set Minus lip = rigid
    set Normal compliance = 0
    set Shear law = rigid
    set Friction angle = 45
    set Cohesion = 0.1
  end
end
subsection Boundaries
  subsection bottom
    set Fixed = x, y
  end
  subsection sides
    set Fixed = x
  end
  subsection crest
    set Fixed = free
  end
end
subsection Loads
  subsection weight
    set Type = weight
  end
  subsection push
    set Type = pressure
    set Boundaries = upstream
    set Value = q*(12 - y)/12
  end
  subsection crane
    set Type = point force
    set Point = 4, 12
    set Value = 0; -0.1
  end
  subsection settlement
    set Type = displacement
    set Boundaries = bottom
    set Value = ; -0.001
  end
end
subsection Stages
  subsection weight
    set Loads = weight: t
  end
  subsection push
    set Loads = push: t; crane: sin(pi*t/2); settlement: t^2
    set Levels = 10
  end
end
subsection Output
  set Fields = end
end
)";
      return text;
    }


    std::string
    replaced(std::string text, const std::vector<std::pair<std::string, std::string>> &changes)
    {
      for (const auto &[from, to] : changes)
        {
          const std::size_t at = text.find(from);
          if (at == std::string::npos)
            ADD_FAILURE() << "not in the example: " << from;
          else
            text.replace(at, from.size(), to);
        }
      return text;
    }
  } // namespace testing_files
} // namespace fuga
