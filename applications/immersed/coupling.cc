// SPDX-License-Identifier: LGPL-2.1-or-later
#include "coupling.h"

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/mapping_q1.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>

namespace Immersed
{
  Coupling::Coupling(const DoFHandler<2> &fluid_dofs,
                     const NavierStokes  &fluid,
                     const Leaflets      &leaflets,
                     const double         beta)
    : beta(beta)
    , fluid_dofs(fluid_dofs)
    , fluid(fluid)
    , leaflets(leaflets)
  {}


  void
  Coupling::locate(const Vector<double> &leaflet_u)
  {
    points.clear();
    const Triangulation<2>   &mesh = fluid_dofs.get_triangulation();
    const GridTools::Cache<2> cache(mesh);
    const Mapping<2>         &mapping = get_default_linear_mapping(mesh);
    const double              h       = GridTools::minimal_cell_diameter(mesh);
    const FiniteElement<2>   &fe_u    = fluid.fe.base_element(0);
    n_fluid                           = 2 * fe_u.n_dofs_per_cell();
    std::vector<types::global_dof_index>   of_cell(fluid.fe.n_dofs_per_cell());
    Triangulation<2>::active_cell_iterator hint;
    for (const auto &cell : leaflets.dof_handler.active_cell_iterators())
      {
        std::array<Point<2>, 2>                ends;
        std::array<types::global_dof_index, 4> dofs;
        for (unsigned int a = 0; a < 2; ++a)
          {
            ends[a] = cell->vertex(a);
            for (unsigned int c = 0; c < 2; ++c)
              {
                dofs[2 * a + c] = cell->vertex_dof_index(a, c);
                ends[a][c] += leaflet_u(dofs[2 * a + c]);
              }
          }
        // at least two points in each cell of the fluid on the way
        const unsigned int n =
          1 + static_cast<unsigned int>(3. * ends[0].distance(ends[1]) / h);
        const double       length = cell->vertex(0).distance(cell->vertex(1));
        const QIterated<1> rule(QGauss<1>(2), n);
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const double xi = rule.point(q)[0];
            CoupledPoint point;
            point.weight = rule.weight(q) * length;
            point.place  = ends[0] + xi * (ends[1] - ends[0]);
            std::pair<Triangulation<2>::active_cell_iterator, Point<2>> at;
            try
              {
                at = GridTools::find_active_cell_around_point(cache,
                                                              point.place,
                                                              hint);
              }
            catch (const ExceptionBase &)
              {}
            AssertThrow(at.first.state() == IteratorState::valid,
                        ExcMessage("Leaflet " +
                                   std::to_string(cell->material_id()) +
                                   " leaves the channel at (" +
                                   std::to_string(point.place[0]) + ", " +
                                   std::to_string(point.place[1]) + ")."));
            hint       = at.first;
            point.pair = {{at.first->level(),
                           at.first->index(),
                           static_cast<int>(cell->active_cell_index())}};
            const DoFHandler<2>::active_cell_iterator fluid_cell(
              &mesh, at.first->level(), at.first->index(), &fluid_dofs);
            const Point<2> unit =
              mapping.transform_real_to_unit_cell(at.first, point.place);
            fluid_cell->get_dof_indices(of_cell);
            for (unsigned int k = 0; k < fe_u.n_dofs_per_cell(); ++k)
              for (unsigned int c = 0; c < 2; ++c)
                {
                  point.dofs.push_back(
                    of_cell[fluid.fe.component_to_system_index(c, k)]);
                  point.shapes.push_back(fe_u.shape_value(k, unit));
                }
            for (unsigned int a = 0; a < 2; ++a)
              for (unsigned int c = 0; c < 2; ++c)
                {
                  point.dofs.push_back(dofs[2 * a + c]);
                  point.shapes.push_back(a == 0 ? xi - 1. : -xi);
                }
            points.push_back(point);
          }
      }
  }


  std::vector<types::global_dof_index>
  Coupling::system_dofs(const CoupledPoint           &point,
                        const types::global_dof_index first) const
  {
    std::vector<types::global_dof_index> dofs = point.dofs;
    for (unsigned int i = 0; i < n_fluid; ++i)
      dofs[i] += first;
    return dofs;
  }


  void
  Coupling::add_couplings(DynamicSparsityPattern          &sparsity,
                          const AffineConstraints<double> &constraints,
                          const types::global_dof_index    first) const
  {
    for (const auto &point : points)
      constraints.add_entries_local_to_global(system_dofs(point, first),
                                              sparsity,
                                              false);
  }


  Tensor<1, 2>
  Coupling::slip(const CoupledPoint   &point,
                 const Vector<double> &flow,
                 const Vector<double> &u,
                 const Vector<double> &old,
                 const double          time_step) const
  {
    Tensor<1, 2> result;
    for (unsigned int i = 0; i < n_fluid; ++i)
      result[i % 2] += point.shapes[i] * flow(point.dofs[i]);
    for (unsigned int i = n_fluid; i < point.dofs.size(); ++i)
      result[i % 2] +=
        point.shapes[i] * (u(point.dofs[i]) - old(point.dofs[i])) / time_step;
    return result;
  }


  void
  Coupling::assemble(const Vector<double>            &flow,
                     const Vector<double>            &u,
                     const Vector<double>            &old,
                     const double                     time_step,
                     const AffineConstraints<double> &constraints,
                     const types::global_dof_index    first,
                     SparseMatrix<double>            &matrix,
                     Vector<double>                  &rhs) const
  {
    const unsigned int n = n_fluid + 4; // two ends of a leaflet's cell
    FullMatrix<double> K(n, n);
    Vector<double>     f(n);
    for (const auto &point : points)
      {
        AssertDimension(point.dofs.size(), n);
        const double       by = beta * point.weight;
        const Tensor<1, 2> w  = slip(point, flow, u, old, time_step);
        for (unsigned int i = 0; i < n; ++i)
          {
            f(i) = -by * point.shapes[i] * w[i % 2];
            for (unsigned int j = i % 2; j < n; j += 2)
              K(i, j) = by * point.shapes[i] * point.shapes[j] /
                        (j < n_fluid ? 1. : time_step);
          }
        constraints.distribute_local_to_global(
          K, f, system_dofs(point, first), matrix, rhs);
      }
  }


  std::vector<std::array<int, 3>>
  Coupling::pairs() const
  {
    std::vector<std::array<int, 3>> result;
    for (const auto &point : points)
      result.push_back(point.pair);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }


  std::vector<Point<2>>
  Coupling::places() const
  {
    std::vector<Point<2>> result;
    for (const auto &point : points)
      result.push_back(point.place);
    return result;
  }
} // namespace Immersed
