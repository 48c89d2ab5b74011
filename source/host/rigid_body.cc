// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/host/rigid_body.h>

#include <algorithm>

namespace MortarContact
{
  template <int dim>
  RigidBody<dim>::RigidBody(const std::string             &name,
                            std::unique_ptr<Obstacle<dim>> surface)
    : name(name)
    , surface(std::move(surface))
  {}


  template <int dim>
  RigidBody<dim>::RigidBody(
    const std::string                            &name,
    const std::vector<Tensor<1, dim>>            &vertices,
    const std::vector<std::vector<unsigned int>> &facets)
    : name(name)
    , vertices(vertices)
    , facets(facets)
  {}


  template <int dim>
  void
  RigidBody<dim>::move(const double time)
  {
    if (prescribed)
      present = prescribed(time);
    if (surface)
      {
        surface->set_time(time);
        surface->motion = present;
        surface->before = before;
      }
  }


  template <int dim>
  void
  RigidBody<dim>::commit()
  {
    before = present;
  }


  template <int dim>
  void
  RigidBody<dim>::restore(const RigidMotion<dim> &saved_present,
                          const RigidMotion<dim> &saved_before)
  {
    present = saved_present;
    before  = saved_before;
  }


  template <int dim>
  void
  RigidBody<dim>::turn(const unsigned int facet)
  {
    std::reverse(facets[facet].begin(), facets[facet].end());
  }


  template <int dim>
  void
  facets_of(const Triangulation<dim - 1, dim>      &mesh,
            std::vector<Tensor<1, dim>>            &vertices,
            std::vector<std::vector<unsigned int>> &facets)
  {
    vertices.clear();
    facets.clear();
    for (const Point<dim> &v : mesh.get_vertices())
      vertices.push_back(v);
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const unsigned int        n = cell->n_vertices();
        std::vector<unsigned int> facet;
        for (unsigned int v = 0; v < n; ++v)
          // deal.II's order of quadrilaterals is lexicographic
          facet.push_back(cell->vertex_index((n == 4 && v >= 2) ? 5 - v : v));
        facets.push_back(facet);
      }
  }


  template class RigidBody<2>;
  template class RigidBody<3>;
  template void
  facets_of<2>(const Triangulation<1, 2> &,
               std::vector<Tensor<1, 2>> &,
               std::vector<std::vector<unsigned int>> &);
  template void
  facets_of<3>(const Triangulation<2, 3> &,
               std::vector<Tensor<1, 3>> &,
               std::vector<std::vector<unsigned int>> &);
} // namespace MortarContact
