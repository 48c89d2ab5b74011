// SPDX-License-Identifier: LGPL-2.1-or-later

// Shells as bodies: loads, directors, closed meshes.

#include <geometry/mesh_maker.h>
#include <structure/shell_body.h>

#include <deal.II/fe/fe_q.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

using namespace dealii;
using namespace Structure;

namespace
{
  MeshParameters
  box(const std::string &map, const unsigned int nx, const unsigned int ny)
  {
    MeshParameters m;
    m.lower = {0., 0.};
    m.upper = {1., 1.};
    m.cells = {nx, ny};
    m.map   = map;
    return m;
  }

  ShellParameters
  steel()
  {
    ShellParameters p;
    p.section         = {1000., 0.3, 0.1, 1.};
    p.contact_modulus = 1000.;
    return p;
  }
  /// A load's tangent against central differences of its forces, in a bent
  /// state.
  void
  expect_derivative(ShellBody &shell, const unsigned int cell, Load<3> &load)
  {
    const unsigned int n = shell.n_dofs_per_cell(cell);
    Vector<double>     u(n), forces(n), plus(n), minus(n);
    FullMatrix<double> K(n, n), none;
    for (unsigned int i = 0; i < n; ++i)
      u(i) = 0.2 * std::sin(1. + 5. * i);
    shell.add_load(cell, load, u, 0., forces, K);
    const double h = 1e-6;
    for (unsigned int i = 0; i < n; ++i)
      {
        Vector<double> a = u, b = u;
        a(i) += h;
        b(i) -= h;
        plus = minus = 0.;
        shell.add_load(cell, load, a, 0., plus, none);
        shell.add_load(cell, load, b, 0., minus, none);
        for (unsigned int j = 0; j < n; ++j)
          EXPECT_NEAR(-(plus(j) - minus(j)) / (2. * h), K(j, i), 1e-8);
      }
  }
} // namespace


TEST(ShellElementBody, FollowerPressureHasItsDerivativeAndPushesTheTop)
{
  for (const bool simplices : {false, true})
    {
      MeshParameters m = box("x; y; 0.2*x*y", 1, 1);
      m.simplices      = simplices;
      Triangulation<2, 3> mesh;
      make_shell_mesh(m, mesh);
      ShellBody shell("shell", mesh, steel(), {}, MPI_COMM_SELF);
      Load<3>   load;
      load.type       = Load<3>::Type::pressure;
      load.on_surface = true;
      load.formulas.emplace_back("2 + x", "Pressure");
      for (unsigned int cell = 0; cell < shell.n_local_cells(); ++cell)
        {
          const unsigned int n = shell.n_dofs_per_cell(cell);
          Vector<double>     u(n), at_rest(n);
          FullMatrix<double> none;
          shell.add_load(cell, load, u, 0., at_rest, none);
          double down = 0.;
          for (unsigned int a = 0; a < n; a += 6)
            down += at_rest(a + 2);
          EXPECT_LT(down, 0.);
          expect_derivative(shell, cell, load);
        }
    }
}


// A moment does the work m . d x d'/d.d on a director: its derivative, and the
// couple of the forces it makes.
TEST(ShellElementBody, MomentOnAnEdgeHasItsDerivativeAndItsCouple)
{
  Triangulation<2, 3> mesh;
  make_shell_mesh(box("x; y; 0.2*x*y", 1, 1), mesh);
  ShellBody shell("shell", mesh, steel(), {}, MPI_COMM_SELF);
  Load<3>   load;
  load.type       = Load<3>::Type::moment;
  load.boundaries = {1};
  for (unsigned int i = 0; i < 3; ++i)
    {
      load.of_component[i] = i;
      load.formulas.emplace_back(i == 0 ? "1" :
                                 i == 1 ? "-2" :
                                          "0.5",
                                 "Moment");
    }
  const unsigned int n = shell.n_dofs_per_cell(0);
  Vector<double>     u(n), at_rest(n);
  FullMatrix<double> none;
  shell.add_load(0, load, u, 0., at_rest, none);
  // at rest, with d = D: the couple sum of D x f is the moment less its part
  // along D, times the edge's length
  Tensor<1, 3> couple, normal;
  for (unsigned int a = 0; a < 4; ++a)
    {
      Tensor<1, 3> D;
      for (unsigned int i = 0; i < 3; ++i)
        D[i] = shell.place_of(0, 6 * a + 3 + i).arm[i];
      const Tensor<1, 3> f(
        {at_rest(6 * a + 3), at_rest(6 * a + 4), at_rest(6 * a + 5)});
      couple += cross_product_3d(D, f);
      normal += 0.25 * D / D.norm();
    }
  const Tensor<1, 3> m({1., -2., 0.5});
  const double       length = std::sqrt(1. + 0.04);
  // the directors of the edge differ from their mean by a tenth
  EXPECT_LT((couple - length * (m - (m * normal) * normal)).norm(),
            0.2 * m.norm());
  expect_derivative(shell, 0, load);
}


// A closed ring: merged vertices leave no edge along the seam, and the skin is
// closed; the volume between two prisms of n sides with radii 1 -+ t/2.
TEST(ShellElementBody, SkinOfAMergedRingIsClosed)
{
  const unsigned int n = 12;
  MeshParameters     m = box("cos(2*pi*x); sin(2*pi*x); 3*y", n, 2);
  m.merges             = true;
  Triangulation<2, 3> mesh;
  make_shell_mesh(m, mesh);
  EXPECT_EQ(mesh.n_used_vertices(), 3 * n);
  unsigned int n_edges = 0;
  for (const auto &cell : mesh.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      n_edges += face->at_boundary();
  EXPECT_EQ(n_edges, 2 * n);

  const std::vector<int> up = orient(mesh);
  const auto             D  = directors_of(mesh, up, {});
  for (unsigned int i = 0; i < mesh.n_vertices(); ++i)
    if (mesh.vertex_used(i))
      {
        // radial; 30 degrees between the faces: a kink, longer by 1/cos(15)
        const Point<3>     x = mesh.get_vertices()[i];
        const Tensor<1, 3> r({x[0], x[1], 0.});
        EXPECT_NEAR(std::abs(D[i] * r), 1. / std::cos(numbers::PI / n), 1e-5);
      }

  FESystem<2, 3>   fe(FE_Q<2, 3>(1), 6);
  DoFHandler<2, 3> dof_handler(mesh);
  dof_handler.distribute_dofs(fe);
  MortarContact::ShellSkin<3> skin;
  skin.thickness   = 0.1;
  skin.modulus     = 1.;
  skin.director    = [&](const unsigned int v) { return D[v]; };
  skin.orientation = [&](const unsigned int c) { return up[c]; };
  Tensor<1, 3> sum;
  double       volume = 0.;
  for (const auto &f :
       MortarContact::extract_shell<3>(dof_handler, {}, skin, "ring", {}))
    {
      MortarContact::Facet<3> facet;
      facet.n_vertices = f.n_vertices;
      for (unsigned int a = 0; a < f.n_vertices; ++a)
        facet.x[a] = f.vertices[a].reference;
      Tensor<1, 3> normal = MortarContact::centre_normal(facet);
      normal *= MortarContact::area(facet) / normal.norm();
      sum += normal;
      volume += normal * MortarContact::centre(facet) / 3.;
    }
  EXPECT_LT(sum.norm(), 1e-12);
  const double outer = 1. + 0.05 / std::cos(numbers::PI / n);
  const double inner = 1. - 0.05 / std::cos(numbers::PI / n);
  EXPECT_NEAR(volume,
              3. * 0.5 * n * std::sin(2. * numbers::PI / n) *
                (outer * outer - inner * inner),
              1e-4);
}


// A square and two triangles beside it, from an Abaqus and a gmsh file: nodes
// are shared, and the skin is closed around area times thickness.
TEST(ShellElementBody, QuadrilateralsAndTrianglesShareNodesAndOneSkin)
{
  std::ofstream("mixed.inp")
    << "*Node\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 2., 0., 0.\n"
       "4, 0., 1., 0.\n5, 1., 1., 0.\n6, 2., 1., 0.\n"
       "*Element, type=S3, elset=a\n1, 2, 3, 6\n2, 2, 6, 5\n"
       "*Element, type=S4, elset=a\n3, 1, 2, 5, 4\n";
  std::ofstream("mixed.msh")
    << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
       "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n"
       "$EndNodes\n$Elements\n3\n1 3 2 5 1 1 2 5 4\n2 2 2 5 1 2 3 6\n"
       "3 2 2 5 1 2 6 5\n$EndElements\n";
  std::ofstream("triangle.inp") << "*Node\n1, 0., 0., 0.\n2, 1., 0., 0.\n"
                                   "3, 0., 1., 0.\n"
                                   "*Element, type=S3, elset=a\n1, 1, 2, 3\n";
  Triangulation<2, 3> only_triangles;
  read_abaqus_shell("triangle.inp", only_triangles);
  EXPECT_EQ(only_triangles.n_active_cells(), 1u);
  for (const char *file : {"mixed.inp", "mixed.msh"})
    {
      MeshParameters m;
      m.type = "file";
      m.file = file;
      Triangulation<2, 3> mesh;
      make_shell_mesh(m, mesh);
      ShellBody shell("shell", mesh, steel(), {}, MPI_COMM_SELF);
      EXPECT_EQ(shell.n_dofs(), 6u * 6u) << file;
      EXPECT_EQ(shell.dofs_in_order().size(), 36u) << file;

      MortarContact::ShellSkin<3> skin;
      skin.thickness = 0.1;
      skin.modulus   = 1.;
      skin.director  = [](const unsigned int) {
        return Tensor<1, 3>({0., 0., 1.});
      };
      const std::vector<int> up = orient(mesh);
      skin.orientation          = [&](const unsigned int c) { return up[c]; };
      double       volume       = 0.;
      Tensor<1, 3> sum;
      const auto   facets =
        MortarContact::extract_shell<3>(shell.dof_handler, {}, skin, "a", {});
      EXPECT_EQ(facets.size(), 2u * 3u + 6u) << file;
      for (const auto &f : facets)
        {
          MortarContact::Facet<3> facet;
          facet.n_vertices = f.n_vertices;
          for (unsigned int a = 0; a < f.n_vertices; ++a)
            facet.x[a] = f.vertices[a].reference;
          Tensor<1, 3> normal = MortarContact::centre_normal(facet);
          normal *= MortarContact::area(facet) / normal.norm();
          sum += normal;
          volume += normal * MortarContact::centre(facet) / 3.;
        }
      EXPECT_LT(sum.norm(), 1e-14) << file;
      EXPECT_NEAR(std::abs(volume), 0.2, 1e-14) << file;
    }
}


TEST(ShellElementBody, OneSidedAndSharplyFoldedSurfacesAreRefused)
{
  const auto refused = [](const std::string &map, const bool merges) {
    MeshParameters m = box(map, 16, 2);
    m.merges         = merges;
    Triangulation<2, 3> mesh;
    make_shell_mesh(m, mesh);
    ShellBody shell("shell", mesh, steel(), {}, MPI_COMM_SELF);
  };
  // a Moebius strip
  EXPECT_THROW(refused("(2 + (y - 0.5)*cos(pi*x))*cos(2*pi*x); "
                       "(2 + (y - 0.5)*cos(pi*x))*sin(2*pi*x); "
                       "(y - 0.5)*sin(pi*x)",
                       true),
               ExceptionBase);
  // a sheet folded by 170 degrees
  EXPECT_THROW(refused("abs(x - 0.5); y; 0.0875*(x - 0.5)", false),
               ExceptionBase);
}
