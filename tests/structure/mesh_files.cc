// SPDX-License-Identifier: LGPL-2.1-or-later
#include <geometry/mesh_maker.h>

#include <deal.II/grid/grid_tools.h>

#include <geometry/surface_reader.h>

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


// A tetrahedron with outward facets: volume 1/6 by the divergence theorem.
TEST(MeshFiles, SurfacesAreReadFromStlAndAbaqus)
{
  const float x[4][3]     = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int   facet[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  {
    std::ofstream text("tet.stl");
    text << "solid tet\n";
    for (const auto &f : facet)
      {
        text << "facet normal 0 0 0\n outer loop\n";
        for (const int v : f)
          text << "  vertex " << x[v][0] << " " << x[v][1] << " " << x[v][2]
               << "\n";
        text << " endloop\nendfacet\n";
      }
    text << "endsolid tet\n";
    std::ofstream     binary("tet_binary.stl", std::ios::binary);
    const std::string head(80, ' ');
    binary.write(head.data(), 80);
    const std::uint32_t n = 4;
    binary.write(reinterpret_cast<const char *>(&n), 4);
    for (const auto &f : facet)
      {
        const float zero[3] = {0, 0, 0};
        binary.write(reinterpret_cast<const char *>(zero), 12);
        for (const int v : f)
          binary.write(reinterpret_cast<const char *>(x[v]), 12);
        binary.write("\0\0", 2);
      }
    std::ofstream abaqus("tet.inp");
    abaqus << "*Heading\n*Node\n";
    for (int v = 0; v < 4; ++v)
      abaqus << v + 1 << ", " << x[v][0] << ", " << x[v][1] << ", " << x[v][2]
             << "\n";
    abaqus << "5, 1., 1., 0.\n*Element, type=S4R\n1, 1, 2, 5, 3\n";
  }
  for (const char *file : {"tet.stl", "tet_binary.stl"})
    {
      std::vector<Tensor<1, 3>>              vertices;
      std::vector<std::vector<unsigned int>> facets;
      Structure::read_surface<3>(file, vertices, facets);
      EXPECT_EQ(vertices.size(), 4u) << file;
      EXPECT_EQ(facets.size(), 4u) << file;
      double volume = 0.;
      for (const auto &f : facets)
        volume += vertices[f[0]] *
                  cross_product_3d(vertices[f[1]], vertices[f[2]]) / 6.;
      EXPECT_NEAR(volume, 1. / 6., 1e-7) << file;
    }
  std::vector<Tensor<1, 3>>              vertices;
  std::vector<std::vector<unsigned int>> facets;
  Structure::read_surface<3>("tet.inp", vertices, facets);
  ASSERT_EQ(facets.size(), 1u);
  EXPECT_EQ(facets[0].size(), 4u);
}
