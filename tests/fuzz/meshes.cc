// SPDX-License-Identifier: LGPL-2.1-or-later
#include "fuzz.h"

#include <geometry/mesh_maker.h>
#include <geometry/surface_reader.h>

// The first byte chooses the reader.
extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  using namespace Structure;
  if (size == 0)
    return 0;
  const auto file = [&](const std::string &name) {
    return Fuzz::file_of(data + 1, size - 1, name);
  };
  Fuzz::read_or_refuse([&]() {
    if (data[0] == 's')
      {
        std::vector<Tensor<1, 3>>              vertices;
        std::vector<std::vector<unsigned int>> facets;
        read_surface(file("fuzz.stl"), vertices, facets);
        return;
      }
    MeshParameters parameters;
    parameters.type = "file";
    if (data[0] == 'm')
      {
        Triangulation<2> mesh;
        parameters.file = file("fuzz.msh");
        make_mesh(parameters, mesh);
        return;
      }
    Triangulation<2, 3> mesh;
    parameters.file = file("fuzz.inp");
    (void)make_shell_mesh(parameters, mesh);
  });
  return 0;
}
