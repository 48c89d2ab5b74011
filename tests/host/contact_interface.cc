// SPDX-License-Identifier: LGPL-2.1-or-later

// The interface as a host sees it, on deal.II's own matrices (one rank) and on
// Trilinos' (any number of ranks), without the drivers.

#include <mortar_contact/mortar_contact.h>

#include <deal.II/base/function.h>
#include <deal.II/base/utilities.h>

#include <deal.II/distributed/shared_tria.h>

#include <deal.II/dofs/dof_renumbering.h>
#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>
#include <deal.II/lac/vector.h>

#include <deal.II/numerics/vector_tools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <sstream>

using namespace dealii;
using namespace MortarContact;

namespace
{
  /// Two blocks in one mesh: block 0 below z = 1 (y = 1), block 1 above.
  /// Contact faces have boundary ids 10 and 20; they overlap by @p overlap.
  template <int dim>
  struct TwoBlocks
  {
    /// @param shuffled Vertices, cells and dofs in a random order (one rank).
    explicit TwoBlocks(const double       overlap,
                       const unsigned int degree   = 1,
                       const bool         curved   = false,
                       const bool         shuffled = false)
      : tria(MPI_COMM_WORLD,
             Triangulation<dim>::none,
             false,
             parallel::shared::Triangulation<dim>::partition_zorder)
      , mapping(degree)
      , fe(FE_Q<dim>(degree), dim)
      , dof_handler(tria)
    {
      Triangulation<dim> a, b;
      Point<dim>         high, low_b, high_b;
      for (unsigned int i = 0; i < dim; ++i)
        {
          high[i]   = 1.;
          low_b[i]  = 0.1;
          high_b[i] = 0.8;
        }
      low_b[dim - 1]  = 1. - overlap;
      high_b[dim - 1] = 1.6;
      std::vector<unsigned int> n_a(dim, 4), n_b(dim, 3);
      GridGenerator::subdivided_hyper_rectangle(a, n_a, Point<dim>(), high);
      GridGenerator::subdivided_hyper_rectangle(b, n_b, low_b, high_b);
      for (const auto &cell : b.active_cell_iterators())
        cell->set_material_id(1);
      Triangulation<dim> both;
      GridGenerator::merge_triangulations(a, b, both, 0.);
      for (const auto &cell : both.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            {
              const double z = cell->face(f)->center()[dim - 1];
              if (cell->material_id() == 0 && std::abs(z - 1.) < 1e-10)
                cell->face(f)->set_boundary_id(10);
              if (cell->material_id() == 1 &&
                  std::abs(z - 1. + overlap) < 1e-10)
                cell->face(f)->set_boundary_id(20);
            }
      if (curved)
        GridTools::transform(
          [](const Point<dim> &p) {
            Point<dim> q = p;
            q[dim - 1] += 0.03 * std::sin(3. * p[0]) * (1. + p[dim - 2]);
            return q;
          },
          both);
      if (shuffled)
        shuffle(both);
      tria.copy_triangulation(both);
      dof_handler.distribute_dofs(fe);
      if (shuffled)
        DoFRenumbering::random(dof_handler);
      constraints.close();
    }

    static void
    shuffle(Triangulation<dim> &mesh)
    {
      std::mt19937 random(7);
      auto [vertices, cells, boundary] =
        GridTools::get_coarse_mesh_description(mesh);
      std::vector<unsigned int> place(vertices.size());
      std::iota(place.begin(), place.end(), 0u);
      std::shuffle(place.begin(), place.end(), random);
      std::vector<Point<dim>> moved(vertices.size());
      for (unsigned int v = 0; v < vertices.size(); ++v)
        moved[place[v]] = vertices[v];
      const auto renumber = [&](auto &objects) {
        for (auto &object : objects)
          for (auto &v : object.vertices)
            v = place[v];
      };
      renumber(cells);
      renumber(boundary.boundary_lines);
      renumber(boundary.boundary_quads);
      std::shuffle(cells.begin(), cells.end(), random);
      mesh.clear();
      mesh.create_triangulation(moved, cells, boundary);
    }

    void
    add_to(ContactInterface<dim> &contact, const bool swapped = false)
    {
      const auto modulus = [](const auto &cell) {
        return cell->material_id() == 0 ? 1000. : 3000.;
      };
      contact.add_secondary(dof_handler,
                            mapping,
                            boundary_ids({swapped ? 20u : 10u}),
                            modulus,
                            "a");
      contact.add_primary(dof_handler,
                          mapping,
                          boundary_ids({swapped ? 10u : 20u}),
                          modulus,
                          "b");
      contact.setup();
    }

    TrilinosWrappers::MPI::Vector
    vector() const
    {
      return TrilinosWrappers::MPI::Vector(dof_handler.locally_owned_dofs(),
                                           MPI_COMM_WORLD);
    }

    parallel::shared::Triangulation<dim> tria;
    MappingQ<dim>                        mapping;
    FESystem<dim>                        fe;
    DoFHandler<dim>                      dof_handler;
    AffineConstraints<double>            constraints;
  };

  template <int dim>
  ContactReport
  evaluate(TwoBlocks<dim>        &blocks,
           ContactInterface<dim> &contact,
           const double           time = 0.)
  {
    contact.update(blocks.vector(), time);
    return contact.report();
  }
} // namespace


TEST(ContactInterface, TangentAgreesWithDifferencesOnCurvedBlocks)
{
  for (const unsigned int degree : {1u, 2u})
    {
      TwoBlocks<3>        blocks(0.02, degree, true);
      ContactInterface<3> contact("i", {}, MPI_COMM_WORLD);
      blocks.add_to(contact);
      EXPECT_LT(contact.check_tangent(blocks.vector()), 1e-6);
      EXPECT_LT(contact.check_balance(), 1e-14);
    }
  TwoBlocks<2>        blocks(0.02, 2, true);
  ContactInterface<2> contact("i", {}, MPI_COMM_WORLD);
  blocks.add_to(contact);
  EXPECT_LT(contact.check_tangent(blocks.vector()), 1e-6);
  EXPECT_LT(contact.check_balance(), 1e-14);
}


TEST(ContactInterface, SidesMayBeSwapped)
{
  TwoBlocks<3>        blocks(0.02, 1, true);
  ContactInterface<3> one("i", {}, MPI_COMM_WORLD),
    other("i", {}, MPI_COMM_WORLD);
  blocks.add_to(one);
  blocks.add_to(other, true);
  const auto a = evaluate(blocks, one), b = evaluate(blocks, other);
  EXPECT_GT(a.force.norm(), 0.);
  EXPECT_LT((a.force + b.force).norm(), 1e-12 * a.force.norm());
  EXPECT_LT((a.moment + b.moment).norm(), 1e-12 * a.moment.norm());
  EXPECT_NEAR(a.largest_penetration, b.largest_penetration, 1e-14);
}


TEST(ContactInterface, NumberingDoesNotMatter)
{
  if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    GTEST_SKIP() << "dofs in a random order on one rank";
  // work of the contact forces and of their tangent in smooth motions, after a
  // smooth slip: no number of a vertex, a cell or a dof is in it
  const auto works = [](const bool shuffled) {
    TwoBlocks<3>      blocks(0.02, 1, true, shuffled);
    ContactParameters p;
    p.friction.coefficient  = 0.05;
    p.friction.elastic_slip = 1e-6;
    ContactInterface<3> contact("i", p, MPI_COMM_WORLD);
    blocks.add_to(contact);
    const auto motion = [&](const double size, const double phase) {
      std::vector<std::function<double(const Point<3> &)>> components;
      for (unsigned int i = 0; i < 3; ++i)
        components.emplace_back([=](const Point<3> &x) {
          return size * std::sin(phase + 2. * i + x * Point<3>(1., 2., 3.));
        });
      Vector<double> v(blocks.dof_handler.n_dofs());
      VectorTools::interpolate(blocks.mapping,
                               blocks.dof_handler,
                               FunctionFromFunctionObjects<3>(components),
                               v);
      return v;
    };
    contact.update(motion(1e-3, 0.), 0.);
    contact.commit(0.);
    contact.update(motion(2e-3, 1.), 1.);
    DynamicSparsityPattern dsp(blocks.dof_handler.n_dofs());
    contact.add_couplings(dsp, blocks.constraints);
    SparsityPattern pattern;
    pattern.copy_from(dsp);
    SparseMatrix<double> matrix(pattern);
    Vector<double>       forces(dsp.n_rows());
    contact.assemble(matrix, forces, blocks.constraints);
    const Vector<double> v = motion(1., 2.), w = motion(1., 3.);
    return std::vector<double>{forces * v,
                               forces * w,
                               matrix.matrix_scalar_product(v, w),
                               matrix.matrix_scalar_product(w, v),
                               contact.report().slip_area};
  };
  const auto in_order = works(false), shuffled = works(true);
  for (unsigned int i = 0; i < in_order.size(); ++i)
    {
      EXPECT_GT(std::abs(in_order[i]), 0.);
      EXPECT_NEAR(shuffled[i], in_order[i], 1e-11 * std::abs(in_order[i]));
    }
}


TEST(ContactInterface, FlatBlocksGiveTheClosedFormOnAnyNumberOfRanks)
{
  // flat blocks have a closed form for the resultant: pressure times area, so
  // the numbers do not come from the code alone
  TwoBlocks<3>      flat(0.01);
  ContactParameters p;
  p.modulus               = 1000.;
  p.characteristic_length = "0.1";
  p.stiffness_side        = "secondary";
  ContactInterface<3> flat_contact("i", p, MPI_COMM_WORLD);
  flat.add_to(flat_contact);
  const auto f = evaluate(flat, flat_contact);
  // p = 0.1 * 0.03 * 1000 * (0.01/0.003 - 1) = 7 on 0.7 x 0.7
  EXPECT_NEAR(f.force[2], -7. * 0.49, 1e-12);
  EXPECT_NEAR(f.active_area, 0.49, 1e-13);
  EXPECT_NEAR(f.moment[0], -7. * 0.49 * 0.45, 1e-12);

  // the busiest rank has no less than the mean, no more than all
  const unsigned int pairs = f.active_pairs + f.open_pairs,
                     ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  EXPECT_GE(f.busiest_rank_pairs * ranks, pairs);
  EXPECT_LE(f.busiest_rank_pairs, pairs);
}


TEST(ContactInterface, SerialMatricesOfDealII)
{
  if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    GTEST_SKIP() << "serial matrices";
  TwoBlocks<3>        blocks(0.02);
  ContactInterface<3> contact("i", {}, MPI_COMM_SELF);
  blocks.add_to(contact);
  Vector<double> u(blocks.dof_handler.n_dofs()), rhs(u.size());
  contact.update(u);
  EXPECT_TRUE(contact.report().couplings_changed);
  DynamicSparsityPattern dsp(u.size());
  contact.add_couplings(dsp, blocks.constraints);
  EXPECT_FALSE(contact.report().couplings_changed);
  SparsityPattern pattern;
  pattern.copy_from(dsp);
  SparseMatrix<double> matrix(pattern);
  contact.assemble(matrix, rhs, blocks.constraints);

  TrilinosWrappers::SparseMatrix trilinos;
  trilinos.reinit(dsp);
  auto forces = blocks.vector();
  contact.assemble(trilinos, forces, blocks.constraints);
  trilinos.compress(VectorOperation::add);
  forces.compress(VectorOperation::add);
  EXPECT_GT(matrix.frobenius_norm(), 0.);
  for (const auto &entry : matrix)
    EXPECT_NEAR(entry.value(),
                trilinos.el(entry.row(), entry.column()),
                1e-14 * matrix.linfty_norm());
  EXPECT_NEAR(rhs.l2_norm(), forces.l2_norm(), 1e-12);
}


TEST(ContactInterface, WideCouplingsHoldThePairsToCome)
{
  if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
    GTEST_SKIP() << "serial matrices";
  TwoBlocks<3>                         blocks(0.02);
  std::vector<types::global_dof_index> dofs(blocks.fe.n_dofs_per_cell());
  // the upper block slides by two thirds of a facet's diameter
  const auto slide = [&](const double motion) {
    ContactInterface<3> contact("i", {}, MPI_COMM_SELF);
    blocks.add_to(contact);
    Vector<double>       u(blocks.dof_handler.n_dofs()), rhs(u.size());
    SparsityPattern      pattern;
    SparseMatrix<double> matrix;
    unsigned int         n_patterns = 0;
    for (unsigned int step = 0; step <= 10; ++step)
      {
        for (const auto &cell : blocks.dof_handler.active_cell_iterators())
          if (cell->material_id() == 1)
            {
              cell->get_dof_indices(dofs);
              for (unsigned int a = 0; a < dofs.size(); ++a)
                if (blocks.fe.system_to_component_index(a).first == 0)
                  u(dofs[a]) = 0.02 * step;
            }
        contact.update(u);
        if (contact.report().couplings_changed)
          {
            DynamicSparsityPattern dsp(u.size());
            contact.add_couplings(dsp, blocks.constraints, motion);
            matrix.clear();
            pattern.copy_from(dsp);
            matrix.reinit(pattern);
            ++n_patterns;
          }
        matrix = 0.;
        contact.assemble(matrix, rhs, blocks.constraints);
      }
    return std::make_pair(n_patterns, matrix.frobenius_norm());
  };
  const auto [many, exact] = slide(0.);
  const auto [one, norm]   = slide(1.);
  EXPECT_GT(many, 1u);
  EXPECT_EQ(one, 1u);
  EXPECT_NEAR(norm, exact, 1e-12 * exact);
}


TEST(ContactInterface, NoFacetPassesAnotherInOneUpdate)
{
  TwoBlocks<3>      blocks(-0.1); // a gap
  ContactParameters p;
  p.characteristic_length = "0.2";
  ContactInterface<3> contact("i", p, MPI_COMM_WORLD);
  blocks.add_to(contact);
  auto u = blocks.vector(), du = blocks.vector();
  contact.update(u);
  std::vector<types::global_dof_index> dofs(blocks.fe.n_dofs_per_cell());
  for (const auto &cell : blocks.dof_handler.active_cell_iterators())
    if (cell->is_locally_owned() && cell->material_id() == 1)
      {
        cell->get_dof_indices(dofs);
        for (unsigned int a = 0; a < dofs.size(); ++a)
          if (blocks.fe.system_to_component_index(a).first == 2 &&
              du.in_local_range(dofs[a]))
            du(dofs[a]) = -10.;
      }
  du.compress(VectorOperation::insert);
  // may close the gap of 0.1 and penetrate by l/2 = 0.1
  EXPECT_NEAR(contact.largest_safe_step(u, du), 0.02, 1e-12);
  du *= -1.;
  EXPECT_EQ(contact.largest_safe_step(u, du), 1.);
}


TEST(ContactInterface, InitialPenetrationsAreTreatedAsAsked)
{
  // THEORY T40 to T42 on two plates with the overlap d0 = 0.01; parabola part
  const auto force_at = [](const InitialPenetration treatment,
                           const double             time,
                           const double             pressure = 0.) {
    TwoBlocks<3>      blocks(0.01);
    ContactParameters p;
    p.modulus               = 1000.;
    p.characteristic_length = "1";
    p.initial_penetration   = treatment;
    p.initial_pressure      = pressure;
    if (treatment == InitialPenetration::remove ||
        treatment == InitialPenetration::remove_deep)
      p.removal_time = 2.;
    if (treatment == InitialPenetration::remove_deep)
      p.deepest_penetration = 0.02;
    ContactInterface<3> contact("i", p, MPI_COMM_WORLD);
    blocks.add_to(contact);
    if (treatment != InitialPenetration::stress)
      {
        EXPECT_GT(contact.report().initial.n_facets, 0u);
        EXPECT_NEAR(contact.report().initial.deepest.penetration, 0.01, 1e-14);
      }
    return -evaluate(blocks, contact, time).force[2] / 0.49;
  };
  // series of two equal sides: K = 500, l = 1; p = 0.1 500 d^2 / (4 0.03)
  const auto sigma = [](const double d) { return 0.1 * 500. * d * d / 0.12; };
  using I          = InitialPenetration;
  EXPECT_NEAR(force_at(I::stress, 0.), sigma(0.01), 1e-13);
  EXPECT_NEAR(force_at(I::track, 0.), 0., 1e-13);
  EXPECT_NEAR(force_at(I::ignore, 0.), 0., 1e-13);
  EXPECT_NEAR(force_at(I::ignore, 7., 1e-3), 1e-3, 1e-13);
  EXPECT_NEAR(force_at(I::remove, 0.), 0., 1e-13);
  EXPECT_NEAR(force_at(I::remove, 0.5), sigma(0.0025), 1e-13);
  EXPECT_NEAR(force_at(I::remove, 2.), sigma(0.01), 1e-13);
  EXPECT_NEAR(force_at(I::remove_deep, 1.), sigma(0.005), 1e-13);
}


namespace
{
  /// Displacement of block 1 by @p by along the last axis.
  template <int dim>
  TrilinosWrappers::MPI::Vector
  lift(TwoBlocks<dim> &blocks, const double by)
  {
    auto                                 u = blocks.vector();
    std::vector<types::global_dof_index> dofs(blocks.fe.n_dofs_per_cell());
    for (const auto &cell : blocks.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && cell->material_id() == 1)
        {
          cell->get_dof_indices(dofs);
          for (unsigned int a = 0; a < dofs.size(); ++a)
            if (blocks.fe.system_to_component_index(a).first == dim - 1 &&
                u.in_local_range(dofs[a]))
              u(dofs[a]) = by;
        }
    u.compress(VectorOperation::insert);
    return u;
  }
} // namespace


TEST(ContactInterface, TrackedPenetrationsFollowTheOpening)
{
  // THEORY T41: force 0 at the start; after full separation the surface is
  // itself again; after partial opening to d1 the offset stays d1
  const double      d0 = 0.01;
  TwoBlocks<3>      blocks(d0);
  ContactParameters p;
  p.modulus               = 1000.;
  p.characteristic_length = "1";
  p.initial_penetration   = InitialPenetration::track;
  const auto sigma = [](const double d) { return 0.1 * 500. * d * d / 0.12; };
  const auto pressure =
    [&](ContactInterface<3> &c, const double up, const bool commit) {
      c.update(lift(blocks, up));
      if (commit)
        c.commit(0.);
      return -c.report().force[2] / 0.49;
    };
  ContactInterface<3> partly("i", p, MPI_COMM_WORLD);
  blocks.add_to(partly);
  EXPECT_NEAR(pressure(partly, 0., true), 0., 1e-13);
  EXPECT_NEAR(pressure(partly, 0.6 * d0, true), 0., 1e-13);
  EXPECT_NEAR(pressure(partly, 0.3 * d0, false), sigma(0.3 * d0), 1e-12);
  // a rejected state leaves no trace
  EXPECT_NEAR(pressure(partly, 2. * d0, false), 0., 1e-13);
  partly.rollback();
  EXPECT_NEAR(pressure(partly, 0.3 * d0, false), sigma(0.3 * d0), 1e-12);

  ContactInterface<3> fully("i", p, MPI_COMM_WORLD);
  blocks.add_to(fully);
  EXPECT_NEAR(pressure(fully, 2. * d0, true), 0., 1e-13);
  EXPECT_NEAR(pressure(fully, 0.5 * d0, true), sigma(0.5 * d0), 1e-12);

  // state survives saving and loading
  std::stringstream saved;
  partly.save(saved);
  ContactInterface<3> again("i", p, MPI_COMM_WORLD);
  blocks.add_to(again);
  again.load(saved, lift(blocks, 0.3 * d0));
  EXPECT_NEAR(pressure(again, 0.3 * d0, false), sigma(0.3 * d0), 1e-12);
}


TEST(ContactInterface, DeepPenetrationsAreNeverSilent)
{
  TwoBlocks<3>      blocks(0.3);
  ContactParameters p;
  p.characteristic_length = "0.1";
  p.initial_penetration   = InitialPenetration::remove;
  p.removal_time          = 1.;
  {
    // IGNORE 3 does not see what is deeper than l/2, and says so (T44)
    ContactInterface<3> contact("i", p, MPI_COMM_WORLD);
    // look at twice the release depth: 0.1 < 0.3 is out of sight; a shallower
    // overlap is in
    TwoBlocks<3> shallower(0.08);
    shallower.add_to(contact);
    EXPECT_GT(contact.report().initial.n_undetected, 0u);
    EXPECT_NEAR(contact.report().initial.undetected.penetration, 0.08, 1e-12);
    EXPECT_NE(contact.report().initial_text().find("WARNING"),
              std::string::npos);
    EXPECT_EQ(evaluate(shallower, contact).active_pairs, 0u);
  }
  p.initial_penetration = InitialPenetration::remove_deep;
  p.deepest_penetration = 0.31;
  {
    ContactInterface<3> contact("i", p, MPI_COMM_WORLD);
    blocks.add_to(contact);
    EXPECT_NEAR(contact.report().initial.deepest.penetration, 0.3, 1e-12);
    EXPECT_NEAR(evaluate(blocks, contact, 0.).force.norm(), 0., 1e-10);
  }
  p.deepest_penetration = 0.2;
  {
    ContactInterface<3> contact("i", p, MPI_COMM_WORLD);
    EXPECT_THROW(blocks.add_to(contact), ExcMessage);
  }
}


TEST(ContactInterface, ReleaseIsJudgedOnConvergedStates)
{
  // THEORY T5: d = 0.51 l converged is released next step and reported; inside
  // an iterate there is force
  TwoBlocks<3>      blocks(0.051);
  ContactParameters p;
  p.characteristic_length = "0.1";
  p.release               = ContactParameters::Release::report;
  ContactInterface<3> contact("i", p, MPI_COMM_WORLD);
  TwoBlocks<3>        touching(0.001);
  touching.add_to(contact);
  const auto down = [&](const double by) { return lift(touching, -by); };
  contact.update(down(0.05));
  EXPECT_GT(contact.report().force.norm(), 0.);
  EXPECT_GT(contact.report().n_too_deep, 0u);
  EXPECT_TRUE(contact.advice().accept);
  contact.commit(0.);
  EXPECT_GT(contact.report().n_released, 0u);
  contact.update(down(0.05));
  EXPECT_EQ(contact.report().force.norm(), 0.);
  // opened and closed again, contact is back
  contact.update(down(-0.01));
  contact.commit(0.);
  contact.update(down(0.01));
  EXPECT_GT(contact.report().force.norm(), 0.);

  p.release = ContactParameters::Release::cut_back;
  ContactInterface<3> strict("i", p, MPI_COMM_WORLD);
  touching.add_to(strict);
  strict.update(down(0.05));
  EXPECT_FALSE(strict.advice().accept);
  EXPECT_NE(strict.advice().reason.find("release"), std::string::npos);
}


TEST(ContactInterface, OffsetsPushTheSurfaceOut)
{
  // THEORY T45: a gap below the offset becomes an initial penetration; with
  // `ignore` and a small pressure it binds loose parts with the stiffness of
  // section 4.5, (alpha K / l) sqrt(p0/(alpha eps K)) per area
  TwoBlocks<3>      blocks(-0.02);
  ContactParameters p;
  p.modulus               = 1000.;
  p.characteristic_length = "1";
  p.stiffness_side        = "secondary";
  p.kind                  = ContactParameters::Kind::forming_surface_to_surface;
  p.secondary_offset      = 0.03;
  p.initial_penetration   = InitialPenetration::ignore;
  p.initial_pressure      = 0.01;
  ContactInterface<3> contact("i", p, MPI_COMM_WORLD);
  blocks.add_to(contact);
  EXPECT_NEAR(contact.report().initial.deepest.penetration, 0.01, 1e-13);
  const auto pressure = [&](const double up) {
    contact.update(lift(blocks, up));
    return -contact.report().force[2] / 0.49;
  };
  EXPECT_NEAR(pressure(0.), 0.01, 1e-10);
  const double h = 1e-6;
  EXPECT_NEAR((pressure(-h) - pressure(h)) / (2. * h),
              100. * std::sqrt(0.01 / 3.),
              1e-6);
}


TEST(ContactInterface, PartlyOverlappingFacetsGetLevelsNoDeeperThanTheOverlap)
{
  // A tip with steep flanks, 0.0136 below the surface at x = 0.567 and 0.004 at
  // the vertex x = 0.5 of it; the facet before that vertex overlaps beyond its
  // last material point only (0.0036 in front of it). At rest there must be
  // next to no force: levels are linear on a facet, and cannot follow the kink
  // in it. Gaps in front of the flanks, up to 0.15, must not make levels that
  // the overlap never had: pressed by twice the overlap, all bears.
  const auto force_at = [](const InitialPenetration treatment,
                           const double             down) {
    TwoBlocks<2> blocks(-1e-3);
    GridTools::transform(
      [](const Point<2> &p) {
        if (std::abs(p[1] - 1.001) > 1e-6)
          return p;
        const std::array<double, 4> by = {{0.15, 0.02, -0.0136, 0.15}};
        return Point<2>(p[0], 1. + by[std::lround((p[0] - 0.1) / 0.7 * 3.)]);
      },
      blocks.tria);
    ContactParameters p;
    p.modulus               = 1000.;
    p.characteristic_length = "1";
    p.initial_penetration   = treatment;
    ContactInterface<2> contact("i", p, MPI_COMM_WORLD);
    blocks.add_to(contact);
    EXPECT_EQ(contact.report().initial.n_facets, 4u); // two on each side
    contact.update(lift(blocks, -down));
    return contact.report().force.norm();
  };
  using I              = InitialPenetration;
  const double at_rest = force_at(I::stress, 0.);
  EXPECT_GT(at_rest, 0.);
  EXPECT_LT(force_at(I::ignore, 0.), 0.1 * at_rest);
  const double further = force_at(I::ignore, 0.0272),
               all     = force_at(I::stress, 0.0272);
  EXPECT_GT(further, 0.7 * all);
  EXPECT_LT(further, all);
}


TEST(ContactInterface, UnusableInputIsRefusedInWords)
{
  TwoBlocks<3>        blocks(0.01);
  ContactInterface<3> contact("floor", {}, MPI_COMM_WORLD);
  const auto          one = [](const auto &) { return 1.; };
  try
    {
      contact.add_secondary(
        blocks.dof_handler, blocks.mapping, boundary_ids({77}), one, "block");
      FAIL();
    }
  catch (const ExcMessage &e)
    {
      const std::string what = e.what();
      EXPECT_NE(what.find("floor"), std::string::npos);
      EXPECT_NE(what.find("empty"), std::string::npos);
    }
  EXPECT_THROW(contact.add_secondary(blocks.dof_handler,
                                     blocks.mapping,
                                     boundary_ids({10}),
                                     [](const auto &) { return -1.; }),
               ExcMessage);
  EXPECT_THROW(contact.setup(), ExcMessage);
  ContactParameters p;
  p.initial_penetration = InitialPenetration::remove;
  EXPECT_THROW(ContactInterface<3>("i", p, MPI_COMM_WORLD), ExcMessage);
}


// What a host may forget: each is refused, in all build types.
TEST(ContactInterface, MistakesOfHostsAreRefusedInWords)
{
  TwoBlocks<3>        blocks(0.02);
  ContactInterface<3> early("i", {}, MPI_COMM_WORLD);
  EXPECT_THROW(early.update(blocks.vector()), ExcMessage);
  const auto modulus = [](const auto &) { return 1000.; };
  early.add_secondary(blocks.dof_handler,
                      blocks.mapping,
                      boundary_ids({10}),
                      modulus);
  early.add_primary(blocks.dof_handler,
                    blocks.mapping,
                    boundary_ids({20}),
                    modulus);
  EXPECT_THROW(early.update(blocks.vector()), ExcMessage);
  EXPECT_THROW(early.add_primary(blocks.dof_handler,
                                 blocks.mapping,
                                 boundary_ids({20}),
                                 modulus,
                                 "b",
                                 {},
                                 1),
               ExcMessage);

  ContactInterface<3> contact("i", {}, MPI_COMM_WORLD);
  blocks.add_to(contact);
  const auto u = blocks.vector();
  // no couplings, no tangent
  TrilinosWrappers::SparseMatrix matrix;
  auto                           rhs = blocks.vector();
  contact.update(u, 1.);
  EXPECT_THROW(contact.assemble(matrix, rhs, blocks.constraints), ExcMessage);
  DynamicSparsityPattern dsp(u.size());
  contact.add_couplings(dsp, blocks.constraints);
  contact.update(u, 1., false);
  EXPECT_THROW(contact.assemble(matrix, rhs, blocks.constraints), ExcMessage);
  // another time; a vector of another mesh; no numbers
  EXPECT_THROW(contact.commit(2.), ExcMessage);
  EXPECT_THROW(contact.update(TrilinosWrappers::MPI::Vector(
                 complete_index_set(12), MPI_COMM_SELF)),
               ExcMessage);
  auto none = blocks.vector();
  for (const auto i : none.locally_owned_elements())
    none(i) = std::numeric_limits<double>::quiet_NaN();
  none.compress(VectorOperation::insert);
  contact.update(none, 1.);
  EXPECT_FALSE(contact.advice().accept);
  EXPECT_THROW(contact.commit(1.), ExcMessage);
  contact.update(u, 1.);
  EXPECT_NO_THROW(contact.commit(1.));
  std::stringstream garbage("nothing of the kind");
  EXPECT_THROW(contact.load(garbage, u), ExcMessage);

  // numbers that no file could hold
  const auto refused = [](const auto &set) {
    ContactParameters p;
    set(p);
    EXPECT_THROW(p.check(), ExcMessage);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](auto &p) { p.stiffness_scale = -1.; });
  refused([&](auto &p) { p.stiffness_scale = nan; });
  refused([](auto &p) { p.penalty_factor = 0.; });
  refused([](auto &p) { p.progressive_stiffening = 0.5; });
  refused([](auto &p) { p.largest_penetration = -1.; });
  refused([](auto &p) { p.friction.coefficient = -0.2; });
  refused([&](auto &p) { p.friction.coefficient = nan; });
  refused([](auto &p) { p.friction.elastic_slip = -1.; });
  refused([](auto &p) { p.stiffness_side = "primary"; });
  refused([](auto &p) { p.augmentation.most = 0; });
}


namespace
{
  /// Displacements of block 1 by a vector.
  template <int dim>
  TrilinosWrappers::MPI::Vector
  shift(TwoBlocks<dim> &blocks, const Tensor<1, dim> &by)
  {
    auto                                 u = blocks.vector();
    std::vector<types::global_dof_index> dofs(blocks.fe.n_dofs_per_cell());
    for (const auto &cell : blocks.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && cell->material_id() == 1)
        {
          cell->get_dof_indices(dofs);
          for (unsigned int a = 0; a < dofs.size(); ++a)
            if (u.in_local_range(dofs[a]))
              u(dofs[a]) = by[blocks.fe.system_to_component_index(a).first];
        }
    u.compress(VectorOperation::insert);
    return u;
  }
} // namespace


// Reference: differences of the forces; balance to round-off; the same state
// after saving and loading. On any number of ranks.
TEST(ContactInterface, FrictionRemembersAndItsTangentIsExact)
{
  for (const double coefficient : {0.05, 10.}) // slips, sticks
    {
      TwoBlocks<3>      blocks(0.02, 1, true);
      ContactParameters p;
      p.friction.coefficient = coefficient;
      ContactInterface<3> contact("i", p, MPI_COMM_WORLD);
      blocks.add_to(contact);
      contact.update(shift(blocks, Tensor<1, 3>({0.004, 0.002, 0.})), 0.5);
      EXPECT_GT(contact.report().elastic_slip, 0.);
      contact.commit(0.5);
      const ContactReport accepted = contact.report();
      std::stringstream   saved;
      contact.save(saved);
      const auto u = shift(blocks, Tensor<1, 3>({0.006, -0.003, -0.002}));
      EXPECT_LT(contact.check_tangent(u, 1.), 2e-6);
      EXPECT_LT(contact.check_balance(), 1e-14);
      contact.update(u, 1.);
      const ContactReport r = contact.report();
      EXPECT_EQ(coefficient<1., r.slip_area> 0.9 * r.active_area);

      ContactInterface<3> other("i", p, MPI_COMM_WORLD);
      blocks.add_to(other);
      other.load(saved, shift(blocks, Tensor<1, 3>({0.004, 0.002, 0.})));
      other.update(u, 1.);
      EXPECT_LT((other.report().force - r.force).norm(),
                1e-14 * r.force.norm());
      EXPECT_NEAR(other.report().dissipation,
                  r.dissipation,
                  1e-14 * r.dissipation);

      contact.rollback();
      EXPECT_EQ(contact.report().force, accepted.force);
      EXPECT_EQ(contact.report().dissipation, accepted.dissipation);
    }
}


TEST(ContactInterface, WithoutFrictionNothingOfItIsStored)
{
  TwoBlocks<3>        blocks(0.02);
  ContactInterface<3> contact("i", {}, MPI_COMM_WORLD);
  blocks.add_to(contact);
  contact.update(blocks.vector(), 1.);
  contact.commit(1.);
  for (unsigned int i = 0; i < contact.n_sweeps(); ++i)
    {
      const auto &state = contact.sweep(i).state();
      EXPECT_TRUE(state.elastic_slip.empty() && state.sliding.empty() &&
                  state.before[0].empty() && state.before[1].empty() &&
                  state.augmentation.empty() && state.tied.empty());
    }
}


TEST(ContactInterface, TiesHoldAcrossAGapAndAreInBalance)
{
  TwoBlocks<3>      blocks(-0.03, 1, true);
  ContactParameters p;
  p.kind          = ContactParameters::Kind::tied;
  p.tie.tolerance = 0.1;
  ContactInterface<3> contact("i", p, MPI_COMM_WORLD);
  blocks.add_to(contact, true); // the smaller block is the secondary
  // a plane facet's area is exact; these are slightly warped
  EXPECT_NEAR(contact.report().initial.tied_area,
              contact.report().initial.secondary_area,
              1e-3);
  EXPECT_GT(contact.report().initial.largest_tied_gap, 0.02);
  EXPECT_LT(contact.report().force.norm(), 1e-12);
  const auto u = shift(blocks, Tensor<1, 3>({0.004, 0.002, 0.01}));
  EXPECT_LT(contact.check_tangent(u), 1e-6);
  EXPECT_LT(contact.check_balance(), 1e-14);
  contact.update(u);
  EXPECT_LT(contact.report().force[2], 0.); // pulled back, though apart

  // too far away: refused
  p.tie.tolerance = 1e-3;
  ContactInterface<3> far("far", p, MPI_COMM_WORLD);
  EXPECT_THROW(blocks.add_to(far), ExcMessage);
}


TEST(ContactInterface, TiebreakFailsThenIsContact)
{
  TwoBlocks<3>      blocks(0.);
  ContactParameters p;
  p.kind                  = ContactParameters::Kind::tiebreak;
  p.tie.strength.law      = TieStrength::Law::strength;
  p.tie.strength.normal   = 5.;
  p.tie.strength.shear    = 5.;
  p.characteristic_length = "0.2";
  ContactInterface<3> contact("i", p, MPI_COMM_WORLD);
  blocks.add_to(contact, true);
  contact.update(lift(blocks, 0.001));
  contact.commit(0.);
  EXPECT_EQ(contact.report().failed_tied_area, 0.);
  const double pull = contact.report().force[2];
  EXPECT_LT(pull, 0.);
  contact.update(lift(blocks, 0.03)); // beyond the strength
  contact.commit(0.);
  contact.update(lift(blocks, 0.03));
  EXPECT_EQ(contact.report().force.norm(), 0.);
  EXPECT_NEAR(contact.report().failed_tied_area, 0.49, 1e-12);
  // pressed again: ordinary contact
  contact.update(lift(blocks, -0.02));
  EXPECT_GT(contact.report().force[2], 0.);
  EXPECT_GT(contact.report().largest_penetration, 0.019);
}


TEST(ContactInterface, RigidBodiesWithFacetsAndSmoothOnesPressAlike)
{
  // a plane above the lower block, 0.02 deep
  TwoBlocks<3>      blocks(-1.);
  ContactParameters p;
  p.characteristic_length = "0.2";
  const auto modulus      = [](const auto &) { return 1000.; };
  const auto plane        = std::make_shared<RigidBody<3>>(
    "plane", std::make_unique<ImplicitObstacle<3>>(plane_shape<3>()));
  // the plane's outside is up: turn it over
  plane->prescribed = [](const double t) {
    RigidMotion<3> m;
    m.rotation       = rotation_by<3>(Tensor<1, 3>({numbers::PI, 0., 0.}));
    m.translation[2] = 0.99 - 0.01 * t;
    return m;
  };
  const auto sheet = std::make_shared<RigidBody<3>>(
    "sheet",
    std::vector<Tensor<1, 3>>{Tensor<1, 3>({-1., -1., 0.99}),
                              Tensor<1, 3>({2., -1., 0.99}),
                              Tensor<1, 3>({2., 2., 0.99}),
                              Tensor<1, 3>({-1., 2., 0.99})},
    std::vector<std::vector<unsigned int>>{{0, 3, 2, 1}});
  sheet->prescribed = [](const double t) {
    RigidMotion<3> m;
    m.translation[2] = -0.01 * t;
    return m;
  };
  for (const auto &body : {plane, sheet})
    {
      ContactInterface<3> contact("i", p, MPI_COMM_WORLD);
      contact.add_secondary(
        blocks.dof_handler, blocks.mapping, boundary_ids({10}), modulus, "a");
      contact.add_primary(body);
      contact.setup();
      contact.update(blocks.vector(), 1.);
      // p = alpha K (d/l - eps), d = 0.02, l = 0.2; area 1
      EXPECT_NEAR(contact.report().force[2], -0.1 * 1000. * (0.1 - 0.03), 1e-10)
        << body->name;
      for (const auto &part : contact.report().parts)
        if (part.name == body->name)
          {
            EXPECT_NEAR(part.force[2], 7., 1e-10);
            EXPECT_NEAR(part.moment[0], 3.5, 1e-10);
          }
      EXPECT_LT(contact.check_tangent(blocks.vector(), 1.), 1e-7);
    }

  // a rigid secondary: the deformable primary's stiffness acts
  p.kind = ContactParameters::Kind::forming_surface_to_surface;
  ContactInterface<3> turned("i", p, MPI_COMM_WORLD);
  turned.add_secondary(sheet);
  turned.add_primary(
    blocks.dof_handler, blocks.mapping, boundary_ids({10}), modulus, "a");
  turned.setup();
  turned.update(blocks.vector(), 1.);
  EXPECT_NEAR(turned.report().force[2], 7., 1e-10);

  // tool normals: away from the blank is refused, or turned
  sheet->turn(0);
  ContactInterface<3> wrong("wrong", p, MPI_COMM_WORLD);
  wrong.add_secondary(
    blocks.dof_handler, blocks.mapping, boundary_ids({10}), modulus, "a");
  sheet->prescribed = [](const double t) {
    RigidMotion<3> m;
    m.translation[2] = 0.05 - 0.07 * t;
    return m;
  };
  wrong.add_primary(sheet);
  EXPECT_THROW(wrong.setup(), ExcMessage);
  {
    // automatic contact says that the blank will pass
    ContactInterface<3> automatic("automatic", {}, MPI_COMM_WORLD);
    automatic.add_secondary(
      blocks.dof_handler, blocks.mapping, boundary_ids({10}), modulus, "a");
    automatic.add_primary(sheet);
    automatic.setup();
    EXPECT_EQ(automatic.report().initial.n_facing_away, 1u);
    EXPECT_NE(automatic.report().initial_text().find("WARNING"),
              std::string::npos);
  }
  p.tool_normals = ContactParameters::ToolNormals::turn;
  ContactInterface<3> mended("mended", p, MPI_COMM_WORLD);
  mended.add_secondary(
    blocks.dof_handler, blocks.mapping, boundary_ids({10}), modulus, "a");
  mended.add_primary(sheet);
  mended.setup();
  EXPECT_EQ(mended.report().initial.n_turned, 1u);
  mended.update(blocks.vector(), 1.);
  EXPECT_LT(mended.report().force[2], -1.);
}


TEST(ContactInterface, SingleSurfaceIsTheSameAsTwoSurfaces)
{
  // THEORY T39: two blocks as one surface: each pair once in each direction;
  // a closed convex body does not see itself
  TwoBlocks<3>        blocks(0.02, 1, true);
  ContactParameters   p;
  ContactInterface<3> two("two", p, MPI_COMM_WORLD);
  blocks.add_to(two);
  p.kind = ContactParameters::Kind::automatic_single_surface;
  ContactInterface<3> one("one", p, MPI_COMM_WORLD);
  const auto          modulus = [](const auto &cell) {
    return cell->material_id() == 0 ? 1000. : 3000.;
  };
  one.add_secondary(
    blocks.dof_handler, blocks.mapping, boundary_ids({10}), modulus, "a");
  one.add_secondary(
    blocks.dof_handler, blocks.mapping, boundary_ids({20}), modulus, "b");
  one.setup();
  two.update(blocks.vector());
  one.update(blocks.vector());
  EXPECT_NEAR(one.report().energy,
              two.report().energy,
              1e-10 * two.report().energy);
  EXPECT_EQ(one.report().active_pairs, two.report().active_pairs);
  EXPECT_NEAR(one.report().parts[0].force[2],
              two.report().parts[0].force[2],
              1e-10 * std::abs(two.report().force[2]));
  EXPECT_NEAR(std::abs(one.report().force[2]),
              std::abs(two.report().force[2]),
              1e-10 * std::abs(two.report().force[2]));
  EXPECT_EQ(one.report().force_on, "a");
  EXPECT_LT(one.check_tangent(blocks.vector()), 1e-6);

  // all faces of two convex blocks far apart, as one part
  TwoBlocks<3>        apart(-1.);
  ContactInterface<3> alone("alone", p, MPI_COMM_WORLD);
  alone.add_secondary(
    apart.dof_handler, apart.mapping, boundary_ids({0, 10, 20}), modulus, "a");
  alone.setup();
  EXPECT_EQ(alone.report().initial.n_facets, 0u);
  EXPECT_EQ(alone.report().initial.n_undetected, 0u);
  alone.update(apart.vector());
  EXPECT_EQ(alone.report().active_pairs, 0u);
}


TEST(ContactInterface, AugmentationKeepsThePressureAndTakesThePenetration)
{
  TwoBlocks<3>      blocks(0.02);
  ContactParameters p;
  p.characteristic_length = "0.2";
  // all of the secondary is covered
  p.kind               = ContactParameters::Kind::forming_surface_to_surface;
  p.augmentation.is_on = true;
  p.augmentation.tolerance = 1e-4;
  ContactInterface<3> contact("i", p, MPI_COMM_WORLD);
  blocks.add_to(contact, true);
  contact.update(blocks.vector());
  const double force = contact.report().force[2];
  EXPECT_TRUE(contact.augment());
  // half way back: the pressure that was there at 0.02 acts at 0
  contact.update(lift(blocks, 0.02));
  EXPECT_NEAR(contact.report().force[2], force, 1e-10 * force);
  EXPECT_LT(contact.report().largest_penetration, 1e-12);
  EXPECT_FALSE(contact.augment());
  EXPECT_LT(contact.check_tangent(lift(blocks, 0.015)), 1e-6);
  // forgotten on request, kept on commit
  contact.rollback();
  contact.update(lift(blocks, 0.02));
  EXPECT_LT(std::abs(contact.report().force[2]), 1e-12);
}


// Reference: differences of the forces, over the body's dofs too.
TEST(ContactInterface, RigidBodiesWithDofsTakeTheResultantAndTheTangentIsExact)
{
  TwoBlocks<3>       blocks(-1.);
  const unsigned int rank    = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  const types::global_dof_index n = blocks.dof_handler.n_dofs();
  IndexSet                      owned(n + 6);
  owned.add_indices(blocks.dof_handler.locally_owned_dofs());
  if (rank + 1 == n_ranks)
    owned.add_range(n, n + 6);
  owned.compress();
  TrilinosWrappers::MPI::Vector u(owned, MPI_COMM_WORLD);

  for (const bool smooth : {true, false})
    for (const double coefficient : {0., 0.3})
      {
        const auto body =
          smooth ? std::make_shared<RigidBody<3>>(
                     "ball",
                     std::make_unique<ImplicitObstacle<3>>(ball_shape<3>(2.))) :
                   std::make_shared<RigidBody<3>>(
                     "sheet",
                     std::vector<Tensor<1, 3>>{Tensor<1, 3>({-1., -1., -2.01}),
                                               Tensor<1, 3>({1.1, -1., -2.}),
                                               Tensor<1, 3>({1., 1.2, -1.99}),
                                               Tensor<1, 3>({-1., 1., -2.})},
                     std::vector<std::vector<unsigned int>>{{0, 3, 2, 1}});
        body->prescribed = [](const double) {
          RigidMotion<3> m;
          m.translation = Tensor<1, 3>({0.5, 0.5, 2.96});
          return m;
        };
        std::array<types::global_dof_index, 6> dofs;
        for (unsigned int i = 0; i < 6; ++i)
          dofs[i] = n + i;
        body->set_dofs(dofs, Tensor<1, 3>({0.3, 0.6, 2.}), 1.5);
        ContactParameters p;
        p.characteristic_length = "0.2";
        p.friction.coefficient  = coefficient;
        ContactInterface<3> contact("i", p, MPI_COMM_WORLD);
        contact.add_secondary(
          blocks.dof_handler,
          blocks.mapping,
          boundary_ids({10}),
          [](const auto &) { return 1000.; },
          "a");
        contact.add_primary(body);
        contact.setup();
        u = 0.;
        if (rank + 1 == n_ranks)
          {
            u(n)     = 0.002;
            u(n + 2) = -0.003;
          }
        u.compress(VectorOperation::insert);
        EXPECT_LT(contact.check_tangent(u), 2e-6) << smooth << coefficient;
        contact.update(u);
        EXPECT_GT(contact.report().active_pairs, 3u);
        // the forces on the body's dofs are the resultant
        TrilinosWrappers::MPI::Vector forces(owned, MPI_COMM_WORLD);
        AffineConstraints<double>     none;
        none.close();
        contact.assemble(forces, none);
        forces.compress(VectorOperation::add);
        Tensor<1, 3> F, M;
        for (const auto &part : contact.report().parts)
          if (part.name == body->name)
            {
              F = part.force;
              M = part.moment -
                  cross_product_3d(body->turning_point(), part.force);
            }
        if (rank + 1 == n_ranks)
          for (unsigned int i = 0; i < 3; ++i)
            {
              EXPECT_NEAR(forces(n + i), F[i], 1e-12 * F.norm());
              EXPECT_NEAR(forces(n + 3 + i), M[i] / 1.5, 1e-12 * F.norm());
            }
      }
}
