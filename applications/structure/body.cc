// SPDX-License-Identifier: LGPL-2.1-or-later
#include "body.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_simplex_p.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <numeric>

namespace Structure
{
  namespace
  {
    /// Deal the active cells to the ranks: equal slices along the direction in
    /// which the mesh is longest.
    template <int dim>
    void
    partition_in_slices(Triangulation<dim> &tria, const unsigned int n_ranks)
    {
      Point<dim> low, high;
      bool       first = true;
      for (const auto &cell : tria.active_cell_iterators())
        {
          const Point<dim> c = cell->center();
          for (unsigned int i = 0; i < dim; ++i)
            {
              low[i]  = first ? c[i] : std::min(low[i], c[i]);
              high[i] = first ? c[i] : std::max(high[i], c[i]);
            }
          first = false;
        }
      unsigned int axis = 0;
      for (unsigned int i = 1; i < dim; ++i)
        if (high[i] - low[i] > high[axis] - low[axis])
          axis = i;

      std::vector<
        std::pair<double, typename Triangulation<dim>::active_cell_iterator>>
        cells;
      for (const auto &cell : tria.active_cell_iterators())
        cells.emplace_back(cell->center()[axis], cell);
      std::stable_sort(cells.begin(),
                       cells.end(),
                       [](const auto &a, const auto &b) {
                         return a.first < b.first;
                       });
      for (std::size_t i = 0; i < cells.size(); ++i)
        cells[i].second->set_subdomain_id(i * n_ranks / cells.size());
    }
  } // namespace


  template <int dim>
  Body<dim>::Body(const std::string        &name,
                  const Triangulation<dim> &mesh,
                  std::unique_ptr<Material> material,
                  const unsigned int        degree,
                  const bool                mean_dilatation,
                  const MPI_Comm            communicator)
    : name(name)
    , material(std::move(material))
    , mean_dilatation(mean_dilatation)
    , triangulation(
        communicator,
        Triangulation<dim>::none,
        false,
        parallel::shared::Triangulation<dim>::partition_custom_signal)
    , dof_handler(triangulation)
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    for (auto *signal : {&triangulation.signals.create,
                         &triangulation.signals.post_refinement})
      signal->connect(
        [this, n_ranks]() { partition_in_slices(triangulation, n_ranks); });
    triangulation.copy_triangulation(mesh);

    const bool simplices = triangulation.all_reference_cells_are_simplex();
    AssertThrow(simplices || triangulation.all_reference_cells_are_hyper_cube(),
                ExcMessage("Body '" + name +
                           "': the mesh mixes cell types; expected hexahedra "
                           "only or tetrahedra only (in 2d quadrilaterals or "
                           "triangles)."));
    AssertThrow(!mean_dilatation || (!simplices && degree == 1),
                ExcMessage("Body '" + name +
                           "': 'Mean dilatation' needs hexahedra "
                           "(quadrilaterals) of degree 1."));
    if (simplices)
      {
        mapping = std::make_unique<MappingFE<dim>>(FE_SimplexP<dim>(1));
        fe = std::make_unique<FESystem<dim>>(FE_SimplexP<dim>(degree), dim);
        quadrature      = std::make_unique<QGaussSimplex<dim>>(degree + 1);
        face_quadrature = std::make_unique<QGaussSimplex<dim - 1>>(degree + 1);
      }
    else
      {
        mapping    = std::make_unique<MappingQ<dim>>(degree);
        fe         = std::make_unique<FESystem<dim>>(FE_Q<dim>(degree), dim);
        quadrature = std::make_unique<QGauss<dim>>(degree + 1);
        face_quadrature = std::make_unique<QGauss<dim - 1>>(degree + 1);
      }
    dof_handler.distribute_dofs(*fe);
  }


  template class Body<2>;
  template class Body<3>;
} // namespace Structure
