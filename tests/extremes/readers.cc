// SPDX-License-Identifier: LGPL-2.1-or-later

// Files that are damaged at random: parameter files, meshes, surfaces,
// checkpoints. A reader reads them or refuses them in words; it never crashes,
// hangs or throws anything else. Each damaged file is read by a process of its
// own.

#include "../support/run_scene.h"

#include <geometry/mesh_maker.h>
#include <geometry/surface_reader.h>
#include <structure/checkpoint.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <random>
#include <sstream>

using namespace Test;

namespace
{
  const std::string source_dir = MORTAR_CONTACT_SOURCE_DIR;

  std::string
  content_of(const std::string &file)
  {
    std::ifstream     in(file, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    EXPECT_FALSE(text.str().empty()) << file;
    return text.str();
  }

  /// One to five kinds of damage.
  std::string
  damaged(std::string text, std::mt19937 &random)
  {
    static const std::vector<std::string> words = {"-1",
                                                   "0",
                                                   "1e308",
                                                   "nan",
                                                   "",
                                                   "99999999999",
                                                   "4294967296",
                                                   "-",
                                                   ",",
                                                   ";",
                                                   "\n",
                                                   "end\n",
                                                   "subsection x\n",
                                                   "set ",
                                                   "*NODE\n",
                                                   "*ELEMENT, TYPE=S4\n",
                                                   "$Elements\n",
                                                   std::string("\0", 1),
                                                   "1e-320",
                                                   "(((((",
                                                   "endsolid"};
    const auto                            below = [&](const std::size_t n) {
      return std::uniform_int_distribution<std::size_t>(0, n)(random);
    };
    for (std::size_t n = 1 + below(4); n > 0; --n)
      {
        const std::size_t at  = below(text.size());
        const std::size_t end = std::min(text.size(), at + 1 + below(40));
        switch (below(6))
          {
            case 0:
              if (at < text.size())
                text[at] = static_cast<char>(below(255));
              break;
            case 1:
              text.erase(at, end - at);
              break;
            case 2:
              text.insert(at, text.substr(at, end - at));
              break;
            case 3:
              text.insert(at, words[below(words.size() - 1)]);
              break;
            case 4:
              text.resize(at);
              break;
            default:
              {
                // a number becomes another one
                const std::size_t digit = text.find_first_of("0123456789", at);
                if (digit != std::string::npos)
                  text.replace(digit,
                               text.find_first_not_of("0123456789", digit) -
                                 digit,
                               words[below(6)]);
              }
          }
      }
    return text;
  }

  enum ExitOfChild
  {
    was_read = 0,
    refused  = 1,
    other    = 2 ///< An exception that is no message.
  };

  /// Read in a process of its own. @return An outcome, or minus a signal.
  int
  outcome_of(const std::function<void()> &read)
  {
    const pid_t child = fork();
    if (child == 0)
      {
        rlimit memory{4ul << 30, 4ul << 30}, core{0, 0};
        setrlimit(RLIMIT_AS, &memory);
        setrlimit(RLIMIT_CORE, &core);
        alarm(20);
        // what deal.II prints on the way is of no interest
        if (freopen("/dev/null", "w", stdout) == nullptr ||
            freopen("/dev/null", "w", stderr) == nullptr)
          _exit(other);
        try
          {
            read();
            _exit(was_read);
          }
        catch (const ExcMessage &)
          {
            _exit(refused);
          }
        catch (...)
          {
            _exit(other);
          }
      }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  /// Damage files with an ending @p n times each.
  void
  damage_and_read(const std::vector<std::string>                 &seeds,
                  const std::string                              &name,
                  const unsigned int                              n,
                  const std::function<void(const std::string &)> &read)
  {
    unsigned int counts[2] = {0, 0};
    for (std::size_t s = 0; s < seeds.size(); ++s)
      for (unsigned int i = 0; i < n; ++i)
        {
          std::mt19937      random(1000 * s + i);
          const std::string text = damaged(seeds[s], random);
          std::ofstream(name, std::ios::binary) << text;
          const int outcome = outcome_of([&]() { read(name); });
          if (outcome == was_read || outcome == refused)
            ++counts[outcome];
          else
            {
              const std::string kept = "found-" + std::to_string(s) + "-" +
                                       std::to_string(i) + "-" + name;
              std::ofstream(kept, std::ios::binary) << text;
              ADD_FAILURE() << kept << " ended with "
                            << (outcome < 0 ? "signal " : "exception ")
                            << std::abs(outcome);
            }
        }
    std::cout << counts[was_read] << " read, " << counts[refused]
              << " refused in words" << std::endl;
    // damage that does no harm, or always harms, tests nothing
    EXPECT_GT(counts[was_read], 0u);
    EXPECT_GT(counts[refused], 0u);
  }

  class DamagedFiles : public testing::TestWithParam<unsigned int>
  {};

  template <int dim, int spacedim>
  void
  read_mesh(const std::string &file)
  {
    MeshParameters parameters;
    parameters.type = "file";
    parameters.file = file;
    Triangulation<dim, spacedim> mesh;
    if constexpr (dim == spacedim)
      make_mesh(parameters, mesh);
    else
      make_shell_mesh(parameters, mesh);
  }

  template <int dim>
  void
  read_facets(const std::string &file)
  {
    std::vector<Tensor<1, dim>>            vertices;
    std::vector<std::vector<unsigned int>> facets;
    read_surface(file, vertices, facets);
  }

  const std::string abaqus_cell =
    "*HEADING\ncell\n*NODE\n"
    "1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n"
    "5, 0., 0., 1.\n6, 1., 0., 1.\n7, 1., 1., 1.\n8, 0., 1., 1.\n"
    "*ELEMENT, TYPE=C3D8R, ELSET=EB1\n1, 1, 2, 3, 4, 5, 6, 7, 8\n";

  const std::string stl_facet =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
    "vertex 0 1 0\nendloop\nendfacet\nfacet normal 0 0 1\nouter loop\n"
    "vertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n"
    "endsolid s\n";
} // namespace


TEST_P(DamagedFiles, OfParameters)
{
  std::vector<std::string> seeds;
  for (const char *name : {"01_two_blocks", "03_friction", "06_shell"})
    seeds.push_back(content_of(source_dir + "/prm/tutorial/" + name + ".prm"));
  damage_and_read(seeds,
                  "damaged.prm",
                  GetParam(),
                  [](const std::string &file) {
                    SceneSource source;
                    source.file   = file;
                    source.driver = "contact_scene";
                    std::string used;
                    (void)read_scene(source, used);
                  });
}


TEST_P(DamagedFiles, OfMeshes)
{
  damage_and_read({content_of(source_dir + "/prm/tutorial/08_hook.msh")},
                  "damaged.msh",
                  GetParam(),
                  read_mesh<2, 2>);
  damage_and_read({abaqus_cell}, "damaged.inp", GetParam(), read_mesh<3, 3>);
}


TEST_P(DamagedFiles, OfShells)
{
  damage_and_read({content_of(source_dir +
                              "/prm/verification/shell_mixed.inp")},
                  "damaged-shell.inp",
                  GetParam(),
                  read_mesh<2, 3>);
}


TEST_P(DamagedFiles, OfSurfaces)
{
  damage_and_read({stl_facet}, "damaged.stl", GetParam(), read_facets<3>);
  damage_and_read({content_of(source_dir +
                              "/prm/verification/shell_mixed.inp")},
                  "damaged-surface.inp",
                  GetParam(),
                  read_facets<3>);
}


TEST_P(DamagedFiles, OfCheckpoints)
{
  const std::string directory = "damaged-checkpoint";
  Checkpoint        checkpoint;
  checkpoint.parameters = "set Driver = contact_scene\n";
  checkpoint.vectors    = {{1., 2., 3.}};
  checkpoint.histories  = {{4.}, {}};
  checkpoint.interfaces = {"text"};
  std::filesystem::create_directories(directory);
  write_checkpoint(checkpoint, directory, MPI_COMM_SELF);
  const std::string state     = directory + "/checkpoint/state";
  const std::string whole     = content_of(state);
  unsigned int      n_refused = 0;
  for (unsigned int i = 0; i < GetParam(); ++i)
    {
      std::mt19937      random(i);
      const std::string text = damaged(whole, random);
      std::ofstream(state, std::ios::binary) << text;
      const int outcome =
        outcome_of([&]() { (void)read_checkpoint(directory, MPI_COMM_SELF); });
      // its sum tells any damage
      EXPECT_EQ(outcome, text == whole ? was_read : refused) << i;
      n_refused += outcome == refused;
    }
  EXPECT_GT(n_refused, 0u);
}


INSTANTIATE_TEST_SUITE_P(Some, DamagedFiles, testing::Values(150u));
INSTANTIATE_TEST_SUITE_P(All, DamagedFiles, testing::Values(5000u));
