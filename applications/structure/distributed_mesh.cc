// SPDX-License-Identifier: LGPL-2.1-or-later
#include "distributed_mesh.h"

#include <deal.II/base/mpi.h>

#include <deal.II/distributed/fully_distributed_tria.h>
#include <deal.II/distributed/shared_tria.h>

#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace Structure
{
  namespace
  {
    /// The rank of each active cell.
    template <int dim, int spacedim>
    std::vector<types::subdomain_id>
    slices_of(const Triangulation<dim, spacedim> &mesh,
              const unsigned int                  n_ranks)
    {
      Point<spacedim>              low, high;
      std::vector<Point<spacedim>> centres;
      for (const auto &cell : mesh.active_cell_iterators())
        {
          const Point<spacedim> c = cell->center();
          for (unsigned int i = 0; i < spacedim; ++i)
            {
              low[i]  = centres.empty() ? c[i] : std::min(low[i], c[i]);
              high[i] = centres.empty() ? c[i] : std::max(high[i], c[i]);
            }
          centres.push_back(c);
        }
      unsigned int axis = 0;
      for (unsigned int i = 1; i < spacedim; ++i)
        if (high[i] - low[i] > high[axis] - low[axis])
          axis = i;

      std::vector<std::pair<double, unsigned int>> order;
      for (unsigned int c = 0; c < centres.size(); ++c)
        order.emplace_back(centres[c][axis], c);
      std::sort(order.begin(), order.end());
      std::vector<types::subdomain_id> ranks(order.size());
      for (std::size_t i = 0; i < order.size(); ++i)
        ranks[order[i].second] = i * n_ranks / order.size();
      return ranks;
    }


    template <int dim, int spacedim>
    std::unique_ptr<parallel::TriangulationBase<dim, spacedim>>
    whole_copy(const Triangulation<dim, spacedim> &mesh,
               const MPI_Comm                      communicator)
    {
      using Mesh      = parallel::shared::Triangulation<dim, spacedim>;
      auto       copy = std::make_unique<Mesh>(communicator,
                                         Triangulation<dim, spacedim>::none,
                                         false,
                                         Mesh::partition_custom_signal);
      const auto deal = [&mesh = *copy,
                         n_ranks =
                           Utilities::MPI::n_mpi_processes(communicator)]() {
        const std::vector<types::subdomain_id> ranks = slices_of(mesh, n_ranks);
        for (const auto &cell : mesh.active_cell_iterators())
          cell->set_subdomain_id(ranks[cell->active_cell_index()]);
      };
      copy->signals.create.connect(deal);
      copy->signals.post_refinement.connect(deal);
      copy->copy_triangulation(mesh);
      return copy;
    }


    /// The cells that this rank keeps, see distribute().
    template <int dim, int spacedim>
    TriangulationDescription::Description<dim, spacedim>
    own_part(const Triangulation<dim, spacedim> &mesh,
             const MPI_Comm                      communicator)
    {
      const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
      const std::vector<types::subdomain_id> ranks =
        slices_of(mesh, Utilities::MPI::n_mpi_processes(communicator));
      std::vector<bool> is_at_own_cell(mesh.n_vertices(), false);
      for (const auto &cell : mesh.active_cell_iterators())
        if (ranks[cell->active_cell_index()] == rank)
          for (const unsigned int v : cell->vertex_indices())
            is_at_own_cell[cell->vertex_index(v)] = true;

      TriangulationDescription::Description<dim, spacedim> result;
      result.comm      = communicator;
      result.settings  = TriangulationDescription::default_setting;
      result.smoothing = Triangulation<dim, spacedim>::none;
      result.cell_infos.resize(1);
      std::vector<unsigned int> new_vertex(mesh.n_vertices(),
                                           numbers::invalid_unsigned_int);
      for (const auto &cell : mesh.active_cell_iterators())
        {
          const auto vertices = cell->vertex_indices();
          if (std::none_of(vertices.begin(), vertices.end(), [&](const auto v) {
                return is_at_own_cell[cell->vertex_index(v)];
              }))
            continue;

          CellData<dim> shape(cell->n_vertices());
          for (const unsigned int v : vertices)
            {
              unsigned int &number = new_vertex[cell->vertex_index(v)];
              if (number == numbers::invalid_unsigned_int)
                {
                  number = result.coarse_cell_vertices.size();
                  result.coarse_cell_vertices.push_back(cell->vertex(v));
                }
              shape.vertices[v] = number;
            }
          shape.material_id = cell->material_id();
          shape.manifold_id = cell->manifold_id();
          result.coarse_cells.push_back(shape);

          const unsigned int c = cell->active_cell_index();
          result.coarse_cell_index_to_coarse_cell_id.push_back(c);
          TriangulationDescription::CellData<dim> info;
          info.id =
            CellId(c, std::vector<std::uint8_t>()).template to_binary<dim>();
          info.subdomain_id       = ranks[c];
          info.level_subdomain_id = ranks[c];
          info.manifold_id        = cell->manifold_id();
          for (const unsigned int l : cell->line_indices())
            info.manifold_line_ids[l] = cell->line(l)->manifold_id();
          if constexpr (dim == 3)
            for (const unsigned int f : cell->face_indices())
              info.manifold_quad_ids[f] = cell->quad(f)->manifold_id();
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary())
              info.boundary_ids.emplace_back(f, cell->face(f)->boundary_id());
          result.cell_infos[0].push_back(std::move(info));
        }
      return result;
    }
  } // namespace


  template <int dim, int spacedim>
  std::unique_ptr<parallel::TriangulationBase<dim, spacedim>>
  distribute(const Triangulation<dim, spacedim> &mesh,
             const bool                          is_whole,
             const MPI_Comm                      communicator)
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    if (is_whole || n_ranks == 1 || mesh.n_active_cells() < n_ranks ||
        mesh.has_hanging_nodes())
      return whole_copy(mesh, communicator);
    auto result = std::make_unique<
      parallel::fullydistributed::Triangulation<dim, spacedim>>(communicator);
    result->create_triangulation(own_part(mesh, communicator));
    for (const auto id : mesh.get_manifold_ids())
      if (id != numbers::flat_manifold_id)
        result->set_manifold(id, mesh.get_manifold(id));
    return result;
  }


  template std::unique_ptr<parallel::TriangulationBase<2, 2>>
  distribute(const Triangulation<2, 2> &, const bool, const MPI_Comm);
  template std::unique_ptr<parallel::TriangulationBase<3, 3>>
  distribute(const Triangulation<3, 3> &, const bool, const MPI_Comm);
  template std::unique_ptr<parallel::TriangulationBase<2, 3>>
  distribute(const Triangulation<2, 3> &, const bool, const MPI_Comm);
} // namespace Structure
