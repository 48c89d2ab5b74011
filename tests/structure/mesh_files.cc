// SPDX-License-Identifier: LGPL-2.1-or-later
#include <geometry/mesh_maker.h>

#include <deal.II/grid/grid_tools.h>

#include <geometry/surface_reader.h>
#include <geometry/thicken.h>

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <utility>

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



// Blank lines, comments, Windows' line ends and what lies behind the elements
// are no reason to refuse a file; wrong counts are, with the line.
TEST(MeshFiles, GmshFilesAreReadOrRefusedWithTheirLine)
{
  const std::string good =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$Nodes\n4\n1 0 0 0\n2 1 0 0\n\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
    "$Elements\n1\n1 3 2 0 1 1 2 3 4\n$EndElements\n$Odd\nthing\n";
  std::string windows;
  for (const char c : good)
    windows += (c == '\n') ? "\r\n" : std::string(1, c);
  for (const std::string &text : {good, windows})
    {
      Triangulation<2> mesh;
      read<2>("good.msh", text, mesh);
      EXPECT_EQ(mesh.n_active_cells(), 1u);
    }
  const auto refusal = [&](const std::string &from, const std::string &to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    Triangulation<2> mesh;
    try
      {
        read<2>("bad.msh", text, mesh);
      }
    catch (const ExcMessage &e)
      {
        std::ostringstream info;
        e.print_info(info);
        return info.str();
      }
    return std::string("read");
  };
  EXPECT_NE(refusal("$Nodes\n4", "$Nodes\n5").find("line 4 announces 5"),
            std::string::npos);
  EXPECT_NE(refusal("$EndElements", "").find("line 16"), std::string::npos);
  EXPECT_NE(refusal("1 3 2 0 1", "1 3 -1 0 1").find("line 14"),
            std::string::npos);
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


// Numbers of elements may be any, in any order: ids follow the names in their
// order, faces lie where Abaqus' manual says.
TEST(MeshFiles, AbaqusSolidsKeepTheirPartsAndSurfacesWhateverTheirNumbers)
{
  const auto deck = [](const std::string &low, const std::string &high) {
    return "*HEADING\n*NODE\n"
           "11, 0, 0, 0\n12, 1, 0, 0\n13, 1, 1, 0\n14, 0, 1, 0\n"
           "21, 0, 0, 1\n22, 1, 0, 1\n23, 1, 1, 1\n24, 0, 1, 1\n"
           "31, 0, 0, 2\n32, 1, 0, 2\n33, 1, 1, 2\n34, 0, 1, 2\n"
           "99, 7, 7, 7\n"
           "*ELEMENT, TYPE=C3D8R, ELSET=RUBBER\n" +
           low +
           ", 11, 12, 13, 14, 21, 22, 23, 24\n"
           "*ELEMENT, TYPE=C3D8, ELSET=STEEL\n" +
           high +
           ", 21, 22, 23, 24, 31, 32, 33, 34\n"
           "*ELSET, ELSET=UPPER\n" +
           high +
           "\n*SURFACE, NAME=TOP, TYPE=ELEMENT\nUPPER, S2\n"
           "*SURFACE, NAME=RIGHT\n" +
           low + ", S4\n" + high +
           ", S4\n*SURFACE, NAME=POINTS, TYPE=NODE\n11, 1.\n"
           "*SOLID SECTION, ELSET=STEEL, MATERIAL=A\n1.\n"
           "*SOLID SECTION, ELSET=RUBBER, MATERIAL=B\n1.\n";
  };
  for (const auto &[low, high] :
       {std::make_pair("1", "2"), std::make_pair("7001", "12")})
    {
      Triangulation<3> mesh;
      std::ofstream("solid.inp") << deck(low, high);
      MeshParameters parameters;
      parameters.type       = "file";
      parameters.file       = "solid.inp";
      const MeshParts parts = make_mesh(parameters, mesh);
      EXPECT_EQ(parts.names.at("STEEL"), 1u);
      EXPECT_EQ(parts.names.at("RUBBER"), 2u);
      EXPECT_EQ(parts.boundaries.at("TOP"), 1u);
      EXPECT_EQ(parts.boundaries.at("RIGHT"), 2u);
      EXPECT_NEAR(GridTools::volume(mesh), 2., 1e-13);
      unsigned int n_top = 0, n_right = 0;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          EXPECT_EQ(cell->material_id(), cell->center()[2] < 1. ? 2u : 1u);
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary())
              {
                n_top += face->boundary_id() == 1 &&
                         std::abs(face->center()[2] - 2.) < 1e-12;
                n_right += face->boundary_id() == 2 &&
                           std::abs(face->center()[0] - 1.) < 1e-12;
              }
        }
      EXPECT_EQ(n_top, 1u);
      EXPECT_EQ(n_right, 2u);
    }
}


// The faces of each type of element: S1, ... have the centres of their nodes.
TEST(MeshFiles, AbaqusFacesOfSimplicesAndQuadrilaterals)
{
  const auto centre_of_face = [](const auto &mesh) {
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->boundary_id() == 1)
          return face->center();
    return mesh.begin_active()->center();
  };
  {
    const std::string nodes =
      "*NODE\n1, 0, 0, 0\n2, 3, 0, 0\n3, 0, 3, 0\n4, 0, 0, 3\n"
      "*ELEMENT, TYPE=C3D4\n5, 1, 2, 3, 4\n*SURFACE, NAME=S\n5, S";
    const std::vector<Point<3>> centres = {{1, 1, 0},
                                           {1, 0, 1},
                                           {1, 1, 1},
                                           {0, 1, 1}};
    for (unsigned int f = 0; f < 4; ++f)
      {
        Triangulation<3> mesh;
        read<3>("solid.inp", nodes + std::to_string(f + 1) + "\n", mesh);
        EXPECT_LT(centre_of_face(mesh).distance(Point<3>(2. * centres[f])),
                  1e-12);
      }
  }
  {
    const std::string nodes =
      "*NODE\n1, 0, 0\n2, 2, 0\n3, 2, 2\n4, 0, 2\n"
      "*ELEMENT, TYPE=CPE4H\n5, 1, 2, 3, 4\n*SURFACE, NAME=S\n5, S";
    const std::vector<Point<2>> centres = {{1, 0}, {2, 1}, {1, 2}, {0, 1}};
    for (unsigned int f = 0; f < 4; ++f)
      {
        Triangulation<2> mesh;
        read<2>("solid.inp", nodes + std::to_string(f + 1) + "\n", mesh);
        EXPECT_LT(centre_of_face(mesh).distance(Point<2>(2. * centres[f])),
                  1e-12);
      }
  }
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



namespace
{
  /// Two squares side by side in the plane z = 0, a section each; the second
  /// with its set by numbers and another name for the first.
  const char *two_sections =
    "*Heading\n** a comment\n*Node\n"
    "10, 0., 0., 0.\n20, 1., 0., 0.\n30, 2., 0., 0.\n"
    "40, 0., 1., 0.\n50, 1., 1., 0.\n60, 2., 1., 0.\n99, 7., 7., 7.\n"
    "*Element, type=S4R,\n elset=all\n7, 10, 20, 50, 40\n8, 20, 30, 60, 50\n"
    "*Elset, elset=Rim, generate\n8, 8, 1\n*Elset, elset=Panel\n7\n"
    "*Shell Section, elset=Panel, material=steel\n0.7, 5\n"
    "*Shell Section, elset=Rim, material=steel\n1.2, 5\n";

  std::string
  message_of(const std::function<void()> &action)
  {
    try
      {
        action();
      }
    catch (const ExcMessage &e)
      {
        std::ostringstream text;
        e.print_info(text);
        return text.str();
      }
    return "";
  }
} // namespace



TEST(MeshFiles, AbaqusShellsHavePartsWithThickness)
{
  std::ofstream("parts.inp") << two_sections;
  MeshParameters parameters;
  parameters.type = "file";
  parameters.file = "parts.inp";
  Triangulation<2, 3> mesh;
  const MeshParts     parts = make_shell_mesh(parameters, mesh);
  EXPECT_EQ(mesh.n_active_cells(), 2u);
  EXPECT_EQ(mesh.n_used_vertices(), 6u);
  ASSERT_EQ(parts.names.size(), 2u);
  EXPECT_EQ(parts.names.at("PANEL"), 1u);
  EXPECT_EQ(parts.names.at("RIM"), 2u);
  EXPECT_EQ(parts.thickness.at(1), 0.7);
  EXPECT_EQ(parts.thickness.at(2), 1.2);
  for (const auto &cell : mesh.active_cell_iterators())
    EXPECT_EQ(cell->material_id(), cell->center()[0] < 1. ? 1u : 2u);
}



TEST(MeshFiles, AbaqusShellErrorsNameFileAndLine)
{
  const auto error = [](const std::string &from, const std::string &to) {
    std::string       text = two_sections;
    const std::size_t at   = text.find(from);
    text.replace(at, from.size(), to);
    std::ofstream("bad.inp") << text;
    return message_of([]() {
      Triangulation<2, 3> mesh;
      (void)read_abaqus_shell("bad.inp", mesh);
    });
  };
  EXPECT_NE(error("S4R", "C3D8").find("line 12 has 'TYPE=C3D8'"),
            std::string::npos);
  EXPECT_NE(error("0.7, 5", "-0.7").find("'-0.7'; expected a positive"),
            std::string::npos);
  EXPECT_NE(error("8, 20, 30", "8, 20, 33").find("has the node 33"),
            std::string::npos);
  EXPECT_NE(error("20, 1., 0", "20, one, 0").find("line 5 has 'one'"),
            std::string::npos);
  EXPECT_NE(error("*", "*\n*").find("line 1 has '*'; expected a keyword"),
            std::string::npos);
  EXPECT_NE(error("*Element",
                  "*Elset, elset=many, generate\n1, 2000000000\n*Element")
              .find("at most 100000000 elements"),
            std::string::npos);
  EXPECT_NE(error("Panel\n7", "Panel\n9").find("element 7 belongs to no"),
            std::string::npos);
  EXPECT_NE(error("8, 20, 30, 60, 50", "8, 20, 30, 30, 30").find("fewer than"),
            std::string::npos);
}



TEST(MeshFiles, GmshShellsHaveNamedParts)
{
  std::ofstream("parts.msh")
    << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
       "$PhysicalNames\n3\n1 4 \"edge\"\n2 5 \"outer panel\"\n2 6 \"rim\"\n"
       "$EndPhysicalNames\n"
       "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 1\n4 0 1 0\n5 1 1 0\n6 2 1 1\n"
       "$EndNodes\n$Elements\n3\n1 1 2 4 1 1 2\n"
       "2 3 2 5 1 1 2 5 4\n3 3 2 6 1 2 3 6 5\n$EndElements\n";
  MeshParameters parameters;
  parameters.type = "file";
  parameters.file = "parts.msh";
  Triangulation<2, 3> mesh;
  const MeshParts     parts = make_shell_mesh(parameters, mesh);
  EXPECT_EQ(mesh.n_active_cells(), 2u);
  ASSERT_EQ(parts.names.size(), 2u);
  EXPECT_EQ(parts.names.at("outer panel"), 5u);
  EXPECT_EQ(parts.names.at("rim"), 6u);
  unsigned int n_edges = 0;
  for (const auto &cell : mesh.active_cell_iterators())
    {
      EXPECT_EQ(cell->material_id(), cell->center()[0] < 1. ? 5u : 6u);
      for (const auto &face : cell->face_iterators())
        n_edges += face->at_boundary() && face->boundary_id() == 4;
    }
  EXPECT_EQ(n_edges, 1u);
}



// A rigid sheet of area 2 and thickness 0.1: a closed surface around the volume
// 0.2 by the divergence theorem, its faces at half the thickness (THEORY T37).
TEST(MeshFiles, ARigidSheetGetsItsThickness)
{
  std::vector<Tensor<1, 3>> x;
  for (const double a : {0., 1., 2.})
    for (const double b : {0., 1.})
      x.push_back(Tensor<1, 3>({a, b, 3.}));
  std::vector<std::vector<unsigned int>> facets = {{0, 2, 3, 1},
                                                   {2, 4, 5},
                                                   {2, 5, 3}};
  thicken(0.1, x, facets);
  EXPECT_EQ(facets.size(), 2u * 3u + 6u);
  double                                                        volume = 0.;
  std::map<std::pair<unsigned int, unsigned int>, unsigned int> edges;
  for (const auto &f : facets)
    for (unsigned int k = 0; k < f.size(); ++k)
      {
        ++edges[{f[k], f[(k + 1) % f.size()]}];
        if (k > 0 && k + 1 < f.size())
          volume += x[f[0]] * cross_product_3d(x[f[k]], x[f[k + 1]]) / 6.;
      }
  EXPECT_NEAR(volume, 0.2, 1e-14);
  for (const auto &[edge, n] : edges)
    {
      EXPECT_EQ(n, 1u);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
  for (const auto &v : x)
    EXPECT_NEAR(std::abs(v[2] - 3.), 0.05, 1e-15);
}
