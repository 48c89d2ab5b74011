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
    if (prescribed && !has_dofs())
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
  RigidBody<dim>::set_dofs(
    const std::array<types::global_dof_index, n_dofs> &numbers,
    const Tensor<1, dim>                              &c,
    const double                                       l)
  {
    own_dofs.assign(numbers.begin(), numbers.end());
    centre = c;
    length = l;
    start  = prescribed ? prescribed(0.) : RigidMotion<dim>();
    move_to({});
    before = present;
  }


  template <int dim>
  void
  RigidBody<dim>::move_to(const std::array<double, n_dofs> &values)
  {
    for (unsigned int i = 0; i < dim; ++i)
      displacement[i] = values[i];
    for (unsigned int k = 0; k < n_rotations; ++k)
      angle[3 - n_rotations + k] = values[dim + k] / length;
    const Tensor<2, dim> R =
      rotation_by<dim>(Tensor<1, 3>(angle - last_angle)) * turned;
    // x = c + u + R (x_0 - c), x_0 the place at the start
    present.centre   = Tensor<1, dim>();
    present.rotation = R * start.rotation;
    present.translation =
      centre + displacement + R * (start.place(Tensor<1, dim>()) - centre);
    if (surface)
      {
        surface->motion = present;
        surface->before = before;
      }
  }


  template <int dim>
  std::array<std::array<double, RigidBody<dim>::n_rotations>,
             RigidBody<dim>::n_rotations>
  RigidBody<dim>::spin_by_dofs() const
  {
    std::array<std::array<double, n_rotations>, n_rotations> T = {};
    if constexpr (dim == 2)
      T[0][0] = 1. / length;
    else
      {
        // T = a I + b [t x] + c t t, t the rotation of the step
        const Tensor<1, 3> t  = angle - last_angle;
        const double       t2 = t.norm_square(), s = std::sqrt(t2);
        const double       a = (s < 1e-4) ? 1. - t2 / 6. : std::sin(s) / s;
        const double b = (s < 1e-4) ? 0.5 - t2 / 24. : (1. - std::cos(s)) / t2;
        const double c = (s < 1e-4) ? 1. / 6. : (1. - a) / t2;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            {
              T[i][j] = ((i == j ? a : 0.) + c * t[i] * t[j]) / length;
              if (i != j)
                T[i][j] +=
                  b * ((j == (i + 1) % 3) ? -1. : 1.) * t[3 - i - j] / length;
            }
      }
    return T;
  }


  template <int dim>
  void
  RigidBody<dim>::commit()
  {
    before     = present;
    turned     = rotation_by<dim>(Tensor<1, 3>(angle - last_angle)) * turned;
    last_angle = angle;
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
