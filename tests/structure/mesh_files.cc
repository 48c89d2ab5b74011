// SPDX-License-Identifier: LGPL-2.1-or-later
#include <geometry/mesh_parameters.h>

#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include <fstream>

using namespace dealii;
using namespace Structure;

namespace
{
  template <int dim>
  void
  read(const std::string  &file,
       const std::string  &content,
       Triangulation<dim> &mesh)
  {
    std::ofstream(file) << content;
    MeshParameters parameters;
    parameters.type  = "file";
    parameters.file  = file;
    parameters.scale = 2.;
    make_mesh(parameters, mesh);
  }
} // namespace



TEST(MeshFiles, GmshQuadrilateralsWithBoundaryIds)
{
  Triangulation<2> mesh;
  read<2>("two_cells.msh",
          "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
          "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n"
          "$EndNodes\n$Elements\n4\n"
          "1 1 2 7 1 1 2\n2 1 2 7 1 2 3\n"         // lines with id 7
          "3 3 2 5 1 1 2 5 4\n4 3 2 6 1 2 3 6 5\n" // quadrilaterals, 5 and 6
          "$EndElements\n",
          mesh);
  EXPECT_EQ(mesh.n_active_cells(), 2u);
  EXPECT_NEAR(GridTools::volume(mesh), 8., 1e-13);
  unsigned int n_7 = 0;
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      n_7 += cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == 7;
  EXPECT_EQ(n_7, 2u);
}



TEST(MeshFiles, AbaqusHexahedron)
{
  Triangulation<3> mesh;
  read<3>("cell.inp",
          "*HEADING\ncell\n*NODE\n"
          "1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n"
          "5, 0., 0., 1.\n6, 1., 0., 1.\n7, 1., 1., 1.\n8, 0., 1., 1.\n"
          "*ELEMENT, TYPE=C3D8R, ELSET=EB1\n1, 1, 2, 3, 4, 5, 6, 7, 8\n",
          mesh);
  EXPECT_EQ(mesh.n_active_cells(), 1u);
  EXPECT_NEAR(GridTools::volume(mesh), 8., 1e-13);
}
