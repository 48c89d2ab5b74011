// SPDX-License-Identifier: LGPL-2.1-or-later

// Outer surfaces of shells: closed, outward, and in balance.

#include <mortar_contact/mortar_contact.h>

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <deal.II/lac/vector.h>

#include <gtest/gtest.h>

#include <sstream>

#include <cmath>
#include <tuple>
#include <utility>

using namespace dealii;
using namespace MortarContact;

namespace
{
  /// A flat square shell (strip in 2d), bent and moved by @p map.
  template <int dim>
  struct Plate
  {
    template <class Map>
    Plate(const unsigned int n, const Map &map)
      : fe(FE_Q<dim - 1, dim>(1), 2 * dim)
      , dof_handler(mesh)
    {
      Triangulation<dim - 1> flat;
      GridGenerator::subdivided_hyper_cube(flat, n);
      GridGenerator::flatten_triangulation(flat, mesh);
      GridTools::transform(map, mesh);
      dof_handler.distribute_dofs(fe);
    }

    ShellSkin<dim>
    skin(const Tensor<1, dim> &director, const int orientation = 1) const
    {
      ShellSkin<dim> s;
      s.thickness      = 0.1;
      s.director_scale = 0.3;
      s.modulus        = 1000.;
      s.director       = [director](const unsigned int) { return director; };
      s.orientation = [orientation](const unsigned int) { return orientation; };
      return s;
    }

    Triangulation<dim - 1, dim> mesh;
    FESystem<dim - 1, dim>      fe;
    DoFHandler<dim - 1, dim>    dof_handler;
  };

  template <int dim>
  Facet<dim>
  reference_of(const SurfaceFacet<dim> &f)
  {
    Facet<dim> facet;
    facet.n_vertices = f.n_vertices;
    for (unsigned int a = 0; a < f.n_vertices; ++a)
      facet.x[a] = f.vertices[a].reference;
    return facet;
  }

  /// A closed surface has no mean normal, and encloses the shell's volume
  /// (divergence theorem).
  template <int dim>
  void
  expect_closed(const Plate<dim>     &plate,
                const ShellSkin<dim> &skin,
                const double          volume)
  {
    const auto facets =
      extract_shell<dim>(plate.dof_handler, {}, skin, "plate", {});
    Tensor<1, dim> sum;
    double         enclosed = 0.;
    for (const auto &f : facets)
      {
        const Facet<dim>     facet = reference_of(f);
        const Tensor<1, dim> n     = centre_normal(facet);
        sum += area(facet) / n.norm() * n;
        enclosed += area(facet) * (n / n.norm()) * centre(facet) / dim;
      }
    EXPECT_LT(sum.norm(), 1e-13);
    EXPECT_NEAR(enclosed, volume, 1e-13);
  }
} // namespace


TEST(ShellSkin, IsClosedAndEnclosesTheShell)
{
  {
    const Plate<3> plate(3, [](const Point<3> &x) { return x; });
    Tensor<1, 3>   up({0., 0., 1.});
    expect_closed(plate, plate.skin(up), 0.1);
    // the top below, where the mesh's own normal does not point
    expect_closed(plate, plate.skin(-up, -1), 0.1);
  }
  {
    const Plate<2> strip(5, [](const Point<2> &x) { return x; });
    Tensor<1, 2>   up({0., 1.});
    expect_closed(strip, strip.skin(up), 0.1);
    expect_closed(strip, strip.skin(-up, -1), 0.1);
  }
}


TEST(ShellSkin, FollowsTheDirectorsAndTellsTopFromBottom)
{
  const Plate<3>     plate(1, [](const Point<3> &x) { return x; });
  const Tensor<1, 3> up({0., 0., 1.});
  const auto         facets = extract_shell<3>(plate.dof_handler,
                                       {{}, {}, true, false, false},
                                       plate.skin(up),
                                       "plate",
                                       {});
  ASSERT_EQ(facets.size(), 1u);
  for (unsigned int a = 0; a < 4; ++a)
    {
      const auto &v = facets[0].vertices[a];
      EXPECT_NEAR(v.reference[2], 0.05, 1e-15);
      // x = X + v + t/(2 s) q
      ASSERT_EQ(v.row.size(), 2u);
      EXPECT_EQ(v.row[0].weight, 1.);
      EXPECT_NEAR(v.row[1].weight, 0.05 / 0.3, 1e-15);
    }
  EXPECT_EQ(extract_shell<3>(plate.dof_handler,
                             {{}, {}, false, false, true},
                             plate.skin(up),
                             "",
                             {})
              .size(),
            4u);
  EXPECT_THROW(extract_shell<3>(plate.dof_handler, {}, ShellSkin<3>(), "", {}),
               ExceptionBase);
}


// THEORY T37: contact of two shells starts where their mid-surfaces are apart
// by half of both thicknesses.
TEST(ShellSkin, ContactStartsAtHalfOfBothThicknesses)
{
  const Tensor<1, 3> up({0., 0., 1.});
  for (const double overlap : {-1e-9, 1e-3})
    {
      const Plate<3>      below(3, [](const Point<3> &x) { return x; });
      const Plate<3>      above(4, [overlap](const Point<3> &x) {
        return Point<3>(0.9 * x[0] + 0.05, 0.9 * x[1] + 0.05, 0.1 - overlap);
      });
      ContactParameters   p;
      ContactInterface<3> contact("shells", p, MPI_COMM_SELF);
      contact.add_secondary(below.dof_handler,
                            {{}, {}, true, false, false},
                            below.skin(up));
      contact.add_primary(above.dof_handler,
                          {{}, {}, false, true, false},
                          above.skin(up),
                          "above",
                          DoFNumbering(below.dof_handler.n_dofs()));
      contact.setup();
      Vector<double> u(below.dof_handler.n_dofs() + above.dof_handler.n_dofs());
      contact.update(u);
      if (overlap < 0.)
        EXPECT_EQ(contact.report().active_area, 0.);
      else
        {
          EXPECT_NEAR(contact.report().active_area, 0.81, 1e-12);
          EXPECT_NEAR(contact.report().largest_penetration, overlap, 1e-12);
        }
    }
}


TEST(ShellSkin, ForcesOfBentShellsAreInBalanceAndTheTangentIsTheirDerivative)
{
  const Tensor<1, 3> up({0., 0., 1.});
  const Plate<3>     below(3, [](const Point<3> &x) { return x; });
  const Plate<3>     above(2, [](const Point<3> &x) {
    return Point<3>(0.9 * x[0] + 0.05, 0.9 * x[1] + 0.05, 0.09);
  });
  for (const double friction : {0., 0.3})
    {
      ContactParameters p;
      p.friction.coefficient = friction;
      ContactInterface<3> contact("shells", p, MPI_COMM_SELF);
      contact.add_secondary(below.dof_handler, {}, below.skin(up));
      contact.add_primary(above.dof_handler,
                          {},
                          above.skin(up),
                          "above",
                          DoFNumbering(below.dof_handler.n_dofs()));
      contact.setup();
      Vector<double> u(below.dof_handler.n_dofs() + above.dof_handler.n_dofs());
      contact.update(u);
      contact.commit(0.);
      for (unsigned int i = 0; i < u.size(); ++i)
        u(i) = 2e-3 * std::sin(1. + 2. * i);
      contact.update(u);
      EXPECT_GT(contact.report().active_area, 0.1);
      EXPECT_LT(contact.check_balance(), 1e-12);
      EXPECT_LT(contact.check_tangent(u), 2e-6);
    }
}


// THEORY T38: a shell's edge is flat, so that it touches a face where its nodes
// do; its faces touch at half the thickness.
TEST(ShellSkin, EdgeTouchesAFaceAtItsNodesAndAFaceAtHalfTheThickness)
{
  ContactParameters p;
  const auto        penetration = [&](const Plate<3>     &shell,
                               const Tensor<1, 3> &director) {
    ContactInterface<3> contact("i", p, MPI_COMM_SELF);
    contact.add_secondary(shell.dof_handler, {}, shell.skin(director));
    contact.add_primary(std::make_shared<RigidBody<3>>(
      "plane", std::make_unique<ImplicitObstacle<3>>(plane_shape<3>())));
    contact.setup();
    contact.update(Vector<double>(shell.dof_handler.n_dofs()));
    return std::make_pair(contact.report().largest_penetration,
                          contact.report().active_area);
  };
  for (const double depth : {-1e-9, 1e-3})
    {
      // on edge: thickness along y
      const Plate<3> upright(3, [depth](const Point<3> &x) {
        return Point<3>(x[0], 0., x[1] - depth);
      });
      const auto on_edge = penetration(upright, Tensor<1, 3>({0., -1., 0.}));
      EXPECT_NEAR(on_edge.first, std::max(depth, 0.), 1e-12);
      EXPECT_NEAR(on_edge.second, depth > 0. ? 0.1 : 0., 1e-12);
      // flat
      const Plate<3> lying(3, [depth](const Point<3> &x) {
        return Point<3>(x[0], x[1], 0.05 - depth);
      });
      const auto     on_face = penetration(lying, Tensor<1, 3>({0., 0., 1.}));
      EXPECT_NEAR(on_face.first, std::max(depth, 0.), 1e-12);
      EXPECT_NEAR(on_face.second, depth > 0. ? 1. : 0., 1e-12);
    }
}


// The interface's entries SST and SFST (THEORY T45 pushes out by the latter).
TEST(ShellSkin, ThicknessForContactMayBeChanged)
{
  const Tensor<1, 3> up({0., 0., 1.});
  const Plate<3>     lying(2, [](const Point<3> &x) {
    return Point<3>(x[0], x[1], 0.05);
  });
  for (const auto &[thickness, scale, depth] :
       {std::make_tuple(0., 1.02, 0.001), std::make_tuple(0.12, 1., 0.01)})
    {
      ContactParameters p;
      p.thickness       = thickness;
      p.thickness_scale = scale;
      ContactInterface<3> contact("i", p, MPI_COMM_SELF);
      contact.add_secondary(lying.dof_handler, {}, lying.skin(up));
      contact.add_primary(std::make_shared<RigidBody<3>>(
        "plane", std::make_unique<ImplicitObstacle<3>>(plane_shape<3>())));
      contact.setup();
      contact.update(Vector<double>(lying.dof_handler.n_dofs()));
      EXPECT_NEAR(contact.report().largest_penetration, depth, 1e-12);
    }
}


TEST(ShellSkin, ThicknessMayVaryFromVertexToVertex)
{
  const Tensor<1, 3> up({0., 0., 1.});
  const Plate<3>     lying(2, [](const Point<3> &x) { return x; });
  ShellSkin<3>       skin      = lying.skin(up);
  const auto         thickness = [](const Tensor<1, 3> &x) {
    return 0.1 + 0.02 * x[0];
  };
  skin.thickness_at = [&](const unsigned int v) {
    return thickness(lying.mesh.get_vertices()[v]);
  };
  for (const auto &facet :
       extract_shell<3>(lying.dof_handler, {}, skin, "s", {}))
    for (unsigned int a = 0; a < facet.n_vertices; ++a)
      {
        const SurfaceVertex<3> &vertex = facet.vertices[a];
        const double            t      = thickness(vertex.reference);
        EXPECT_NEAR(std::abs(vertex.reference[2]), 0.5 * t, 1e-15);
        // the director's share: (t/2)/s on the top, the opposite below
        for (const auto &entry : vertex.row)
          if (entry.weight != 1.)
            {
              EXPECT_NEAR(entry.weight, vertex.reference[2] / 0.3, 1e-15);
            }
      }
}


// A shell's edge pushed into that of its neighbour brings the top of the one
// over the bottom of the other, a thickness behind it: that is no contact, nor
// the loss of one, until they have parted; contact from in front stays one.
TEST(ShellSkin, FacesThatMeetFromTheSideAreNoContactUntilTheyPart)
{
  const Tensor<1, 3> up({0., 0., 1.});
  const Plate<3>     left(2, [](const Point<3> &x) { return x; });
  const Plate<3>     right(2, [](const Point<3> &x) {
    return Point<3>(x[0] + 1.01, x[1], x[2]);
  });
  const unsigned int n_left  = left.dof_handler.n_dofs();
  const auto         connect = [&](ContactInterface<3> &contact) {
    contact.add_secondary(left.dof_handler,
                          {{}, {}, true, false, false},
                          left.skin(up));
    contact.add_primary(right.dof_handler,
                        {{}, {}, false, true, false},
                        right.skin(up),
                        "right",
                        DoFNumbering(n_left));
    contact.setup();
  };
  ContactInterface<3> contact("shells", {}, MPI_COMM_SELF);
  connect(contact);

  const auto moved = [&](const double x, const double z) {
    Vector<double>                       u(n_left + right.dof_handler.n_dofs());
    std::vector<types::global_dof_index> dofs(right.fe.dofs_per_cell);
    for (const auto &cell : right.dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const unsigned int c = right.fe.system_to_component_index(i).first;
            u(n_left + dofs[i])  = (c == 0) ? x : (c == 2) ? z : 0.;
          }
      }
    return u;
  };
  double     time = 0.;
  const auto move = [&](const double x, const double z) {
    time += 1.;
    contact.update(moved(x, z), time, false);
    return contact.advice().accept;
  };

  // beside each other, then over each other by 0.01, a thickness deep
  EXPECT_TRUE(move(0., 0.));
  contact.commit(time);
  // (and beyond reach); then 0.08, and 0.04, where contact would push back
  for (const double z : {0., 0.02, 0.06})
    {
      EXPECT_TRUE(move(-0.02, z));
      EXPECT_EQ(contact.report().largest_penetration, 0.);
      EXPECT_EQ(contact.report().force.norm(), 0.);
      contact.commit(time);
    }
  // the same after saving and loading
  std::stringstream saved;
  contact.save(saved);
  ContactInterface<3> again("shells", {}, MPI_COMM_SELF);
  connect(again);
  again.load(saved, moved(-0.02, 0.06));
  again.update(moved(-0.02, 0.06), time + 1., false);
  EXPECT_EQ(again.report().force.norm(), 0.);
  EXPECT_FALSE(contact.sweep(0).state().aside.empty());
  EXPECT_EQ(again.sweep(0).state().aside, contact.sweep(0).state().aside);
  // they part, and meet again from in front
  for (const double x : {0.1, -0.3})
    {
      EXPECT_TRUE(move(x, 0.2));
      contact.commit(time);
    }
  EXPECT_TRUE(move(-0.3, 0.09));
  EXPECT_NEAR(contact.report().largest_penetration, 0.01, 1e-12);
  EXPECT_NEAR(contact.report().active_area, 0.29, 1e-12);
  EXPECT_GT(contact.report().force.norm(), 0.);
  contact.commit(time);
  // this contact would be lost
  EXPECT_FALSE(move(-0.3, 0.03));
}
