// SPDX-License-Identifier: LGPL-2.1-or-later

// Contact between bodies of distributed meshes, of which a rank knows only its
// part: hexahedra with hanging nodes in the contact, tetrahedra, shells.

#include <mortar_contact/mortar_contact.h>

#include <deal.II/base/function.h>

#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/distributed/tria.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_fe.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria_description.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <deal.II/numerics/vector_tools.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

using namespace dealii;
using namespace MortarContact;

namespace
{
  using Vector_t = TrilinosWrappers::MPI::Vector;

  /// Two blocks (shells: sheets) that do not match, one above the other, in one
  /// mesh; the lower has material 0. Faces in contact are 10 and 20.
  template <int dim>
  void
  two_blocks(const bool of_simplices, Triangulation<dim, 3> &mesh)
  {
    Triangulation<dim, 3> a, b;
    const Point<3>        high_b(0.8, 0.85, 1.6);
    const double          bottom = 0.98;
    if constexpr (dim == 3)
      {
        const auto make = [&](Triangulation<3>                &block,
                              const std::vector<unsigned int> &n,
                              const Point<3>                  &low,
                              const Point<3>                  &high) {
          if (of_simplices)
            GridGenerator::subdivided_hyper_rectangle_with_simplices(block,
                                                                     n,
                                                                     low,
                                                                     high);
          else
            GridGenerator::subdivided_hyper_rectangle(block, n, low, high);
        };
        make(a, {4, 4, 2}, Point<3>(), Point<3>(1., 1., 1.));
        make(b, {3, 3, 2}, Point<3>(0.1, 0.15, bottom), high_b);
      }
    else
      {
        const auto make = [](Triangulation<2, 3> &sheet,
                             const unsigned int   n,
                             const double         low,
                             const double         high,
                             const double         z) {
          Triangulation<2> flat;
          GridGenerator::subdivided_hyper_cube(flat, n, low, high);
          GridGenerator::flatten_triangulation(flat, sheet);
          GridTools::transform(
            [z](const Point<3> &p) { return p + Point<3>(0., 0., z); }, sheet);
        };
        make(a, 4, 0., 1., 1.);
        make(b, 3, 0.1, 0.85, 1.18);
      }
    for (const auto &cell : b.active_cell_iterators())
      cell->set_material_id(1);
    GridGenerator::merge_triangulations(a, b, mesh, 0.);
    if constexpr (dim == 3)
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary())
            {
              const double z = cell->face(f)->center()[2];
              if (cell->material_id() == 0 && std::abs(z - 1.) < 1e-10)
                cell->face(f)->set_boundary_id(10);
              if (cell->material_id() == 1 && std::abs(z - bottom) < 1e-10)
                cell->face(f)->set_boundary_id(20);
            }
  }

  /// Halve the cells of the lower body near a corner, twice.
  template <int dim>
  void
  refine_locally(Triangulation<dim, 3> &mesh)
  {
    for (const double size : {0.6, 0.35})
      {
        for (const auto &cell : mesh.active_cell_iterators())
          if (cell->is_locally_owned() && cell->material_id() == 0 &&
              cell->center()[0] < size && cell->center()[1] < size)
            cell->set_refine_flag();
        mesh.execute_coarsening_and_refinement();
      }
  }

  /// What does not depend on numbers of cells and dofs: resultant, energy,
  /// area, and the work of forces and of the tangent in smooth motions.
  template <int dim>
  std::vector<double>
  figures(const Triangulation<dim, 3> &mesh,
          const FiniteElement<dim, 3> &fe,
          const Mapping<dim, 3>       &mapping,
          const MPI_Comm               communicator)
  {
    DoFHandler<dim, 3> dof_handler(mesh);
    dof_handler.distribute_dofs(fe);
    const IndexSet &owned = dof_handler.locally_owned_dofs();

    ContactParameters parameters;
    parameters.friction.coefficient  = 0.1;
    parameters.friction.elastic_slip = 1e-4;
    ContactInterface<3> contact("i", parameters, communicator);
    if constexpr (dim == 3)
      {
        const auto modulus = [](const auto &cell) {
          return cell->material_id() == 0 ? 1000. : 3000.;
        };
        contact.add_secondary(
          dof_handler, mapping, boundary_ids({10}), modulus, "lower");
        contact.add_primary(
          dof_handler, mapping, boundary_ids({20}), modulus, "upper");
      }
    else
      {
        ShellSkin<3> skin;
        skin.thickness = 0.2;
        skin.modulus   = 1000.;
        skin.director = [](const unsigned int) { return Point<3>(0., 0., 1.); };
        skin.orientation = [](const unsigned int) { return 1; };
        contact.add_secondary(dof_handler, material_ids({0}), skin, "lower");
        contact.add_primary(dof_handler, material_ids({1}), skin, "upper");
      }
    contact.setup();

    // hanging nodes: also those of other ranks that contact writes to
    IndexSet relevant;
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
    relevant.add_indices(contact.relevant_dofs(dof_handler.n_dofs()));
    AffineConstraints<double> constraints(relevant);
    DoFTools::make_hanging_node_constraints(dof_handler, constraints);
    constraints.make_consistent_in_parallel(owned, relevant, communicator);
    constraints.close();

    const auto motion = [&](const double size, const double phase) {
      std::vector<std::function<double(const Point<3> &)>> components;
      for (unsigned int i = 0; i < fe.n_components(); ++i)
        components.emplace_back([=](const Point<3> &x) {
          return size * std::sin(phase + 2. * i + x * Point<3>(1., 2., 3.));
        });
      Vector_t v(owned, communicator);
      VectorTools::interpolate(mapping,
                               dof_handler,
                               FunctionFromFunctionObjects<3>(components),
                               v);
      constraints.distribute(v);
      return v;
    };
    contact.update(motion(1e-3, 0.), 0.);
    contact.commit(0.);
    contact.update(motion(2e-3, 1.), 1.);

    // rows of what hanging nodes of other ranks hang on come, too
    const types::global_dof_index n = dof_handler.n_dofs();
    DynamicSparsityPattern        dsp(n, n);
    contact.add_couplings(dsp, constraints);
    SparsityTools::distribute_sparsity_pattern(dsp,
                                               owned,
                                               communicator,
                                               complete_index_set(n));
    TrilinosWrappers::SparseMatrix matrix;
    matrix.reinit(owned, owned, dsp, communicator);
    Vector_t forces(owned, communicator), product(owned, communicator);
    contact.assemble(matrix, forces, constraints);
    matrix.compress(VectorOperation::add);
    forces.compress(VectorOperation::add);
    const Vector_t v = motion(1., 2.), w = motion(1., 3.);
    matrix.vmult(product, v);
    const ContactReport &r = contact.report();
    EXPECT_LT(contact.check_balance(), 1e-13);
    return {r.force[0],
            r.force[1],
            r.force[2],
            r.moment[0],
            r.energy,
            r.dissipation,
            r.active_area,
            r.largest_penetration,
            static_cast<double>(r.active_pairs),
            forces * v,
            forces * w,
            product * w};
  }

  void
  compare(const std::vector<double> &found, const std::vector<double> &expected)
  {
    for (unsigned int i = 0; i < expected.size(); ++i)
      {
        EXPECT_NE(expected[i], 0.) << i;
        EXPECT_NEAR(found[i], expected[i], 1e-10 * std::abs(expected[i])) << i;
      }
  }
} // namespace


// References: the same on a serial mesh, by each rank alone.

TEST(Distributed, HexahedraWithHangingNodesInTheContact)
{
  const FESystem<3>  fe(FE_Q<3>(1), 3);
  const MappingFE<3> mapping(FE_Q<3>(1));
  Triangulation<3>   coarse, serial;
  two_blocks(false, coarse);
  serial.copy_triangulation(coarse);
  refine_locally(serial);
  parallel::distributed::Triangulation<3> distributed(MPI_COMM_WORLD);
  distributed.copy_triangulation(coarse);
  refine_locally(distributed);
  ASSERT_EQ(distributed.n_global_active_cells(), serial.n_active_cells());
  EXPECT_TRUE(serial.has_hanging_nodes());
  compare(figures(distributed, fe, mapping, MPI_COMM_WORLD),
          figures(serial, fe, mapping, MPI_COMM_SELF));
}


TEST(Distributed, Tetrahedra)
{
  const FE_SimplexP<3> scalar(1);
  const FESystem<3>    fe(scalar, 3);
  const MappingFE<3>   mapping(scalar);
  Triangulation<3>     serial;
  two_blocks(true, serial);
  const auto reference = figures(serial, fe, mapping, MPI_COMM_SELF);
  GridTools::partition_triangulation_zorder(
    Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD), serial);
  parallel::fullydistributed::Triangulation<3> distributed(MPI_COMM_WORLD);
  distributed.create_triangulation(
    TriangulationDescription::Utilities::create_description_from_triangulation(
      serial, MPI_COMM_WORLD));
  compare(figures(distributed, fe, mapping, MPI_COMM_WORLD), reference);
}


TEST(Distributed, Shells)
{
  const FESystem<2, 3>  fe(FE_Q<2, 3>(1), 6);
  const MappingFE<2, 3> mapping(FE_Q<2, 3>(1));
  Triangulation<2, 3>   coarse, serial;
  two_blocks(false, coarse);
  serial.copy_triangulation(coarse);
  refine_locally(serial);
  parallel::distributed::Triangulation<2, 3> distributed(MPI_COMM_WORLD);
  distributed.copy_triangulation(coarse);
  refine_locally(distributed);
  ASSERT_EQ(distributed.n_global_active_cells(), serial.n_active_cells());
  compare(figures(distributed, fe, mapping, MPI_COMM_WORLD),
          figures(serial, fe, mapping, MPI_COMM_SELF));
}


namespace
{
  /// A block above a long strip, in one mesh; the strip has material 0.
  void
  block_on_strip(Triangulation<3> &mesh)
  {
    Triangulation<3> strip, block;
    GridGenerator::subdivided_hyper_rectangle(strip,
                                              {24, 2, 1},
                                              Point<3>(),
                                              Point<3>(12., 1.5, 1.));
    GridGenerator::subdivided_hyper_rectangle(block,
                                              {3, 2, 2},
                                              Point<3>(0.2, 0.3, 1.02),
                                              Point<3>(1.6, 1.3, 2.));
    for (const auto &cell : block.active_cell_iterators())
      cell->set_material_id(1);
    GridGenerator::merge_triangulations(strip, block, mesh, 0.);
    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int f : cell->face_indices())
        if (cell->face(f)->at_boundary())
          cell->face(f)->set_boundary_id(cell->material_id() == 0 ? 10 : 20);
  }

  /// Motion of the block.
  struct Place
  {
    double along, down;
  };

  /// The block where places say, one after the other: what the interface says
  /// there. Also the share of all facets that ranks know in the mean.
  std::vector<double>
  slide(const Triangulation<3>   &mesh,
        const ContactParameters  &parameters,
        const std::vector<Place> &places,
        const MPI_Comm            communicator,
        double                   &known)
  {
    const FESystem<3>  fe(FE_Q<3>(1), 3);
    const MappingFE<3> mapping(FE_Q<3>(1));
    DoFHandler<3>      dof_handler(mesh);
    dof_handler.distribute_dofs(fe);
    const IndexSet     &owned = dof_handler.locally_owned_dofs();
    ContactInterface<3> contact("i", parameters, communicator);
    const auto          modulus = [](const auto &) { return 1000.; };
    const bool          is_single =
      parameters.kind == ContactParameters::Kind::automatic_single_surface;
    contact.add_secondary(
      dof_handler, mapping, boundary_ids({10}), modulus, "strip");
    if (is_single)
      contact.add_secondary(
        dof_handler, mapping, boundary_ids({20}), modulus, "block");
    else
      contact.add_primary(
        dof_handler, mapping, boundary_ids({20}), modulus, "block");
    contact.setup();
    const auto at = [&](const Place &place) {
      Vector_t v(owned, communicator);
      VectorTools::interpolate(mapping,
                               dof_handler,
                               FunctionFromFunctionObjects<3>(
                                 {[&](const Point<3> &x) {
                                    return x[2] > 1.01 ? place.along : 0.;
                                  },
                                  [&](const Point<3> &) { return 0.; },
                                  [&](const Point<3> &x) {
                                    return x[2] > 1.01 ?
                                             -place.down :
                                             1e-3 * std::sin(3. * x[0] + x[1]);
                                  }}),
                               v);
      return v;
    };
    std::vector<double> result;
    double              time = 0.;
    Vector_t            last(owned, communicator);
    for (const Place &place : places)
      {
        const Vector_t now = at(place);
        Vector_t       du  = now;
        du -= last;
        result.push_back(contact.largest_safe_step(last, du));
        contact.update(now, ++time);
        AffineConstraints<double> constraints;
        constraints.close();
        const types::global_dof_index n = dof_handler.n_dofs();
        DynamicSparsityPattern        dsp(n, n);
        contact.add_couplings(dsp, constraints, 0.5);
        SparsityTools::distribute_sparsity_pattern(dsp,
                                                   owned,
                                                   communicator,
                                                   complete_index_set(n));
        TrilinosWrappers::SparseMatrix matrix;
        matrix.reinit(owned, owned, dsp, communicator);
        Vector_t forces(owned, communicator), product(owned, communicator);
        contact.assemble(matrix, forces, constraints);
        matrix.compress(VectorOperation::add);
        forces.compress(VectorOperation::add);
        matrix.vmult(product, now);
        result.push_back(forces * now);
        result.push_back(product * now);
        // numbers of cells are others on other meshes
        double pressure = 0., shear = 0.;
        for (const auto &state : facet_states(contact, communicator))
          for (unsigned int a = 0; a < 4; ++a)
            {
              const double weight =
                (1. + state.side) * (1. + state.current.x[a][0]);
              pressure += weight * state.pressure[a];
              shear += weight * state.shear[a];
            }
        result.push_back(pressure);
        result.push_back(shear);
        contact.commit(time);
        const ContactReport &r = contact.report();
        for (const auto &part : r.parts)
          for (unsigned int c = 0; c < 3; ++c)
            result.push_back(part.force[c]);
        result.insert(result.end(),
                      {double(r.active_pairs),
                       double(r.n_released),
                       r.energy,
                       r.dissipation,
                       r.active_area,
                       r.largest_penetration});
        last = now;
      }
    unsigned int mine = 0, all = 0;
    for (const unsigned int side : {0u, 1u})
      {
        mine += contact.surface(side).skin.facets.size();
        all += contact.report().initial.n_side_facets[side];
      }
    known = Utilities::MPI::sum(double(mine), communicator) /
            (all * Utilities::MPI::n_mpi_processes(communicator));
    return result;
  }

  /// On a distributed mesh as on a serial one, by each rank alone.
  /// @return What slide() says of the facets known.
  double
  compare_slides(const ContactParameters  &parameters,
                 const std::vector<Place> &places)
  {
    Triangulation<3> serial;
    block_on_strip(serial);
    parallel::distributed::Triangulation<3> distributed(MPI_COMM_WORLD);
    distributed.copy_triangulation(serial);
    double     known = 0.;
    const auto expected =
      slide(serial, parameters, places, MPI_COMM_SELF, known);
    EXPECT_EQ(known, 1.);
    const auto found =
      slide(distributed, parameters, places, MPI_COMM_WORLD, known);
    EXPECT_EQ(found.size(), expected.size());
    double scale = 0.;
    for (const double value : expected)
      scale = std::max(scale, std::abs(value));
    EXPECT_GT(scale, 0.);
    for (unsigned int i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 1e-10 * scale) << i;
    return known;
  }
} // namespace


// No rank knows a whole surface: facets come when they come near, wherever
// their rank is, and remember what friction needs.
TEST(Distributed, FacetsOfOtherRanksComeWhenTheyComeNear)
{
  ContactParameters parameters;
  parameters.friction.coefficient  = 0.2;
  parameters.friction.elastic_slip = 1e-3;
  std::vector<Place> places;
  for (double along = 0.; along < 11.; along += 2.4)
    places.push_back({along, 0.03});
  const double known = compare_slides(parameters, places);
  if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 3)
    {
      EXPECT_LT(known, 0.75);
    }
}


TEST(Distributed, FacetsOfASingleSurfaceComeWhenTheyComeNear)
{
  ContactParameters parameters;
  parameters.kind = ContactParameters::Kind::automatic_single_surface;
  compare_slides(parameters, {{0., 0.03}, {1., 0.03}, {6., 0.03}, {10., 0.03}});
}


// Released in the middle of the strip, the block leaves below it, comes back
// from above at another place, and has contact again.
TEST(Distributed, ReleasedFacetsOpenWhereverTheOtherSideIs)
{
  ContactParameters parameters;
  parameters.release = ContactParameters::Release::report;
  compare_slides(parameters,
                 {{5., 0.03},
                  {5., 0.9},
                  {9., 0.9},
                  {10., 0.9},
                  {10., -1.},
                  {2., -1.},
                  {2., 0.03}});
}
