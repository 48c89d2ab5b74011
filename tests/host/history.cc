// SPDX-License-Identifier: LGPL-2.1-or-later

// What an interface remembers follows its material points to other meshes and
// other ranks. The host's mesh is p4est's, refined and dealt anew in between.

#include <mortar_contact/mortar_contact.h>
#include <mortar_contact/search/material_locator.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q1.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <deal.II/lac/trilinos_vector.h>

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <sstream>

using namespace dealii;
using namespace MortarContact;

namespace
{
  using Motion = std::function<Tensor<1, 3>(const Point<3> &)>;

  /// A block on a larger one, which it overlaps; ids 10 above and 20 below.
  struct Blocks
  {
    explicit Blocks(const double overlap)
      : tria(MPI_COMM_WORLD)
      , fe(FE_Q<3>(1), 3)
      , dof_handler(tria)
    {
      Triangulation<3> below, above, both;
      GridGenerator::subdivided_hyper_rectangle(below,
                                                {4, 4, 2},
                                                Point<3>(),
                                                Point<3>(1., 1., 1.));
      GridGenerator::subdivided_hyper_rectangle(above,
                                                {3, 2, 2},
                                                Point<3>(0.2,
                                                         0.2,
                                                         1. - overlap),
                                                Point<3>(0.7, 0.7, 1.5));
      for (const auto &cell : above.active_cell_iterators())
        cell->set_material_id(1);
      GridGenerator::merge_triangulations(below, above, both, 0.);
      for (const auto &cell : both.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            {
              const double z = cell->face(f)->center()[2];
              if (cell->material_id() == 1 && std::abs(z - 1. + overlap) < 1e-9)
                cell->face(f)->set_boundary_id(10);
              if (cell->material_id() == 0 && std::abs(z - 1.) < 1e-9)
                cell->face(f)->set_boundary_id(20);
            }
      tria.copy_triangulation(both);
      dof_handler.distribute_dofs(fe);
    }

    void
    refine(const bool uniformly)
    {
      for (const auto &cell : tria.active_cell_iterators())
        if (cell->is_locally_owned() && (uniformly || cell->center()[0] < 0.4))
          cell->set_refine_flag();
      tria.execute_coarsening_and_refinement();
      dof_handler.distribute_dofs(fe);
    }

    std::unique_ptr<ContactInterface<3>>
    interface(const ContactParameters &p) const
    {
      auto contact =
        std::make_unique<ContactInterface<3>>("blocks", p, MPI_COMM_WORLD);
      const MappingQ1<3> mapping;
      const auto         modulus = [](const auto &) { return 1000.; };
      contact->add_secondary(
        dof_handler, mapping, boundary_ids({10}), modulus, "above");
      contact->add_primary(
        dof_handler, mapping, boundary_ids({20}), modulus, "below");
      contact->setup();
      return contact;
    }

    /// The block above moves.
    TrilinosWrappers::MPI::Vector
    moved(const Motion &motion) const
    {
      TrilinosWrappers::MPI::Vector        u(dof_handler.locally_owned_dofs(),
                                      MPI_COMM_WORLD);
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() == 1)
          {
            cell->get_dof_indices(dofs);
            for (unsigned int i = 0; i < dofs.size(); ++i)
              if (u.in_local_range(dofs[i]))
                {
                  const auto [c, v] = fe.system_to_component_index(i);
                  u(dofs[i])        = motion(cell->vertex(v))[c];
                }
          }
      u.compress(VectorOperation::insert);
      return u;
    }

    parallel::distributed::Triangulation<3> tria;
    FESystem<3>                             fe;
    DoFHandler<3>                           dof_handler;
  };

  Motion
  shift(const double x, const double y, const double z)
  {
    return [=](const Point<3> &) { return Tensor<1, 3>({x, y, z}); };
  }

  /// A small turn about the vertical through (0.45, 0.45), and a shift.
  Motion
  turn(const double by, const double z)
  {
    return [=](const Point<3> &p) {
      return Tensor<1, 3>({-by * (p[1] - 0.45), by * (p[0] - 0.45), z});
    };
  }

  /// Two committed motions, then @p last: on one mesh; then the last one on
  /// finer meshes, which continue from the first. The stiffness is given, so
  /// that the answer is the same on all meshes where fields are linear.
  void
  compare(ContactParameters p, const Motion &first, const Motion &last)
  {
    p.modulus               = 1000.;
    p.characteristic_length = "0.2";
    for (const bool uniformly : {true, false})
      {
        Blocks blocks(0.02);
        auto   contact = blocks.interface(p);
        contact->update(blocks.moved(first), 1.);
        EXPECT_TRUE(contact->advice().accept);
        contact->commit(1.);
        std::stringstream saved;
        contact->save(saved);
        contact->update(blocks.moved(last), 2.);
        const ContactReport expected = contact->report();

        blocks.refine(uniformly);
        auto fine = blocks.interface(p);
        fine->load(saved, blocks.moved(first));
        fine->update(blocks.moved(last), 2.);
        const ContactReport &r = fine->report();
        const double size      = expected.force.norm() + expected.moment.norm();
        EXPECT_GT(size, 0.);
        EXPECT_LT((r.force - expected.force).norm(), 1e-10 * size);
        EXPECT_LT((r.moment - expected.moment).norm(), 1e-10 * size);
        EXPECT_NEAR(r.dissipation,
                    expected.dissipation,
                    1e-10 * std::abs(expected.dissipation));
        EXPECT_NEAR(r.damage_dissipation,
                    expected.damage_dissipation,
                    1e-9 * expected.damage_dissipation);
        // it goes on from there
        fine->commit(2.);
        EXPECT_LT(fine->check_tangent(blocks.moved(last), 3.), 1e-5);
      }
  }
} // namespace


TEST(History, TrackedLevelsFollowToFinerMeshes)
{
  ContactParameters p;
  p.initial_penetration = InitialPenetration::track;
  compare(p, shift(0., 0., 0.008), shift(0., 0., 0.003));
}


TEST(History, ElasticSlipFollowsToFinerMeshes)
{
  ContactParameters p;
  p.friction.coefficient = 100.; // sticks: the slip is a linear field
  compare(p, turn(1e-3, 0.), turn(-1e-3, 0.));
}


TEST(History, AugmentationFollowsToFinerMeshes)
{
  ContactParameters p;
  p.modulus                = 1000.;
  p.characteristic_length  = "0.2";
  p.augmentation.is_on     = true;
  p.augmentation.tolerance = 1e-6;
  Blocks blocks(0.02);
  auto   contact = blocks.interface(p);
  contact->update(blocks.moved(shift(0., 0., 0.01)), 1.);
  EXPECT_TRUE(contact->augment());
  contact->update(blocks.moved(shift(0., 0., 0.01)), 1.);
  contact->commit(1.);
  std::stringstream saved;
  contact->save(saved);
  contact->update(blocks.moved(shift(0., 0., 0.015)), 2.);
  const double expected = contact->report().force[2];
  blocks.refine(false);
  auto fine = blocks.interface(p);
  fine->load(saved, blocks.moved(shift(0., 0., 0.01)));
  fine->update(blocks.moved(shift(0., 0., 0.015)), 2.);
  EXPECT_NEAR(fine->report().force[2], expected, 1e-10 * expected);
}


TEST(History, DamageOfTiesFollowsToFinerMeshes)
{
  ContactParameters p;
  p.kind                       = ContactParameters::Kind::tiebreak;
  p.tie.strength.law           = TieStrength::Law::cohesive;
  p.tie.strength.normal        = 2.;
  p.tie.strength.shear         = 2.;
  p.tie.strength.energy_normal = 0.05;
  p.tie.strength.energy_shear  = 0.05;
  p.tie.tolerance              = 0.1;
  compare(p, shift(0., 0., 0.02), shift(0., 0., 0.01));
}


// A state that some facets have does not spread to their neighbours, whatever
// ranks they are on.
TEST(History, ReleasedFacetsAreTheSameAfterLoading)
{
  ContactParameters p;
  p.modulus               = 1000.;
  p.characteristic_length = "0.2";
  p.release               = ContactParameters::Release::report;
  Blocks     blocks(0.02);
  const auto tilted  = blocks.moved([](const Point<3> &x) {
    return Tensor<1, 3>({0., 0., -0.4 * (x[0] - 0.45)});
  });
  auto       contact = blocks.interface(p);
  contact->update(tilted, 1.);
  contact->commit(1.);
  EXPECT_GT(contact->report().n_released, 0u);
  std::stringstream saved;
  contact->save(saved);
  auto again = blocks.interface(p);
  again->load(saved, tilted);
  unsigned int n_kept = 0, n_free = 0;
  for (unsigned int i = 0; i < contact->n_sweeps(); ++i)
    {
      const auto &before = contact->sweep(i).state().released;
      const auto &after  = again->sweep(i).state().released;
      ASSERT_EQ(after.size(),
                contact->surface(contact->side_of(i, 0)).skin.n_own);
      for (std::size_t f = 0; f < after.size(); ++f)
        {
          EXPECT_EQ(bool(after[f]), !before.empty() && before[f]);
          ++(after[f] ? n_kept : n_free);
        }
    }
  EXPECT_GT(Utilities::MPI::sum(n_kept, MPI_COMM_WORLD), 0u);
  EXPECT_GT(Utilities::MPI::sum(n_free, MPI_COMM_WORLD), 0u);
}


// The centre of a plane facet may lie an ulp off its plane: (0.1 + 0.1 + 0.1)/3
// is not 0.1.
TEST(History, TheSameFacetIsFoundWhateverItsCoordinates)
{
  std::vector<Facet<3>> facets;
  for (const double z : {0.1, 1. / 3., 0.7, 2.3})
    {
      Facet<3> f;
      f.n_vertices = 3;
      f.x[0]       = Tensor<1, 3>({0., 0., z});
      f.x[1]       = Tensor<1, 3>({1., 0., z});
      f.x[2]       = Tensor<1, 3>({0., 1., z});
      facets.push_back(f);
    }
  const MaterialLocator<3> locator(facets, {0, 0, 0, 0});
  for (unsigned int f = 0; f < facets.size(); ++f)
    {
      ASSERT_TRUE(locator.same(facets[f], 0)) << f;
      EXPECT_EQ(*locator.same(facets[f], 0), f);
    }
}


// Reference: the points of the coarse facets that the fine ones were made of.
TEST(History, MaterialPointsAreFoundOnOtherMeshes)
{
  // two parts, back to back, in cells of 1; bulged
  std::vector<Facet<3>>     facets;
  std::vector<unsigned int> parts;
  const auto                place = [](const double x, const double y) {
    return Tensor<1, 3>({x, y, 0.1 * x * y});
  };
  for (unsigned int part = 0; part < 2; ++part)
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int j = 0; j < 4; ++j)
        {
          Facet<3> f;
          f.n_vertices = 4;
          f.x          = {{place(i, j),
                           place(i + 1., j),
                           place(i + 1., j + 1.),
                           place(i, j + 1.)}};
          facets.push_back(f);
          parts.push_back(part);
        }
  const MaterialLocator<3>               locator(facets, parts);
  std::mt19937                           random(3);
  std::uniform_real_distribution<double> uniform(0., 1.);
  for (unsigned int n = 0; n < 200; ++n)
    {
      const unsigned int f = random() % facets.size();
      PlanePoint<3>      xi;
      xi[0]         = uniform(random);
      xi[1]         = uniform(random);
      const auto x  = interpolate(facets[f], shape_values<3>(4, xi));
      const auto up = Tensor<1, 3>({0.1, 0.1, 1.});
      const auto at = locator.find(x, up, parts[f]);
      ASSERT_TRUE(at);
      EXPECT_EQ(at->facet, f);
      EXPECT_LT((at->xi - xi).norm(), 1e-2); // along the facet's mean normal
      EXPECT_LT(at->distance, 1e-2);
      EXPECT_FALSE(locator.find(x, -up, parts[f]));
      EXPECT_FALSE(locator.find(x, up, 2));
      ASSERT_TRUE(locator.same(facets[f], parts[f]));
      EXPECT_EQ(*locator.same(facets[f], parts[f]), f);
    }
}
