// SPDX-License-Identifier: LGPL-2.1-or-later

// The hot loops one by one (Google Benchmark): clipping, the pair kernel with
// and without its tangent, the search over a growing cloud of facets, and what
// an interface takes per pair: update() of 60 x 60 on 49 x 49 facets, and the
// assembly into a matrix. Build with -DMORTAR_CONTACT_BENCHMARKS=ON, run
// build/micro_benchmarks.

#include "../tests/support/facet_pair.h"

#include <mortar_contact/geometry/clipping.h>
#include <mortar_contact/laws/paper_law.h>
#include <mortar_contact/mortar_contact.h>
#include <mortar_contact/search/broad_phase.h>

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/grid_generator.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <benchmark/benchmark.h>

#include <random>

using namespace Test;

namespace
{
  /// Facets as they meet: a hundred pairs that overlap in general position.
  const std::vector<Pair3d> &
  pairs(const unsigned int n_vertices)
  {
    static const auto make = [](const unsigned int n) {
      std::vector<Pair3d> result;
      for (unsigned int seed = 0; seed < 100; ++seed)
        result.emplace_back(n, n, 0.02, 0.05, seed);
      return result;
    };
    static const std::vector<Pair3d> triangles      = make(3),
                                     quadrilaterals = make(4);
    return n_vertices == 3 ? triangles : quadrilaterals;
  }

  void
  clipping(benchmark::State &state)
  {
    // two squares, the second turned: an octagon
    PlaneFacet<3> a, b;
    for (unsigned int i = 0; i < 4; ++i)
      {
        const double angle = numbers::PI * (0.25 + 0.5 * i);
        a[i]               = PlanePoint<3>({std::cos(angle), std::sin(angle)});
        b[i] = PlanePoint<3>({std::cos(angle + 0.7), std::sin(angle + 0.7)});
      }
    const auto pieces_a = convex_pieces<3>(4, a);
    const auto pieces_b = convex_pieces<3>(4, b);
    for (auto _ : state)
      benchmark::DoNotOptimize(
        clip<3>(a, pieces_a.pieces[0], b, pieces_b.pieces[0], 1e-13));
    state.SetItemsProcessed(state.iterations());
  }

  void
  pair_kernel(benchmark::State &state)
  {
    const bool          with_tangent = state.range(1) == 1;
    const PaperLaw      law(PressureCurve::parabola_linear, 0.1);
    const PairKernel<3> kernel(law, nullptr, KernelOptions());
    const auto         &all = pairs(state.range(0));
    std::size_t         i   = 0;
    for (auto _ : state)
      {
        const Pair3d &pair = all[i++ % all.size()];
        PairBlock<3>  block;
        kernel.evaluate_segments(SecondaryFrame<3>(pair.secondary.current),
                                 pair.secondary,
                                 pair.offset,
                                 pair.primary,
                                 nullptr,
                                 1.,
                                 with_tangent,
                                 block);
        benchmark::DoNotOptimize(block);
      }
    state.SetItemsProcessed(state.iterations());
  }

  /// Boxes of facets of a cloud of sheared plates, all of one size.
  std::vector<Box<3>>
  cloud(const std::size_t n)
  {
    std::mt19937                           random(1);
    std::uniform_real_distribution<double> u(0., 1.);
    const double        size = 1. / std::cbrt(static_cast<double>(n));
    std::vector<Box<3>> boxes(n);
    for (Box<3> &box : boxes)
      for (unsigned int i = 0; i < 3; ++i)
        {
          box.low[i]  = u(random);
          box.high[i] = box.low[i] + size;
        }
    return boxes;
  }

  void
  search(benchmark::State &state)
  {
    const std::vector<Box<3>> boxes = cloud(state.range(0));
    for (auto _ : state)
      {
        const BroadPhase<3> tree(boxes);
        std::size_t         n = 0;
        for (const Box<3> &box : boxes)
          n += tree.find(box).size();
        benchmark::DoNotOptimize(n);
      }
    state.SetComplexityN(state.range(0));
    state.SetItemsProcessed(state.iterations() * state.range(0));
  }

  /// Two plates, one cell thick, whose meshes do not match.
  struct Plates
  {
    Plates()
      : mapping(1)
      , fe(FE_Q<3>(1), 3)
      , dof_handler(mesh)
      , contact("plates", {}, MPI_COMM_SELF)
    {
      Triangulation<3> lower, upper;
      GridGenerator::subdivided_hyper_rectangle(lower,
                                                {60, 60, 1},
                                                Point<3>(0., 0., 0.),
                                                Point<3>(1., 1., 0.1));
      GridGenerator::subdivided_hyper_rectangle(upper,
                                                {49, 49, 1},
                                                Point<3>(0., 0., 0.099),
                                                Point<3>(1., 1., 0.2));
      GridGenerator::merge_triangulations(lower, upper, mesh, 0.);
      for (const auto &face : mesh.active_face_iterators())
        if (face->at_boundary())
          face->set_boundary_id(std::abs(face->center()[2] - 0.1) < 1e-9   ? 1 :
                                std::abs(face->center()[2] - 0.099) < 1e-9 ? 2 :
                                                                             0);
      dof_handler.distribute_dofs(fe);
      constraints.close();
      u.reinit(dof_handler.n_dofs());
      forces.reinit(u.size());
      const auto modulus = [](const auto &) { return 100.; };
      contact.add_secondary(
        dof_handler, mapping, boundary_ids({1}), modulus, "lower");
      contact.add_primary(
        dof_handler, mapping, boundary_ids({2}), modulus, "upper");
      contact.setup();
      contact.update(u);
      DynamicSparsityPattern dsp(u.size());
      contact.add_couplings(dsp, constraints);
      pattern.copy_from(dsp);
      matrix.reinit(pattern);
    }

    Triangulation<3>          mesh;
    MappingQ<3>               mapping;
    FESystem<3>               fe;
    DoFHandler<3>             dof_handler;
    AffineConstraints<double> constraints;
    ContactInterface<3>       contact;
    Vector<double>            u, forces;
    SparsityPattern           pattern;
    SparseMatrix<double>      matrix;
  };

  void
  interface_update(benchmark::State &state)
  {
    Plates plates;
    for (auto _ : state)
      plates.contact.update(plates.u);
    state.SetItemsProcessed(state.iterations() *
                            plates.contact.report().active_pairs);
  }

  void
  assembly(benchmark::State &state)
  {
    Plates plates;
    for (auto _ : state)
      plates.contact.assemble(plates.matrix, plates.forces, plates.constraints);
    state.SetItemsProcessed(state.iterations() *
                            plates.contact.report().active_pairs);
  }
} // namespace

BENCHMARK(clipping);
BENCHMARK(pair_kernel)
  ->ArgNames({"vertices", "tangent"})
  ->Args({3, 0})
  ->Args({3, 1})
  ->Args({4, 0})
  ->Args({4, 1});
BENCHMARK(search)
  ->RangeMultiplier(4)
  ->Range(1 << 12, 1 << 18)
  ->Unit(benchmark::kMillisecond)
  ->Complexity();
BENCHMARK(interface_update)->Unit(benchmark::kMillisecond);
BENCHMARK(assembly)->Unit(benchmark::kMillisecond);

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
