// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_host_pair_forces_h
#define mortar_contact_host_pair_forces_h

#include <mortar_contact/mortar/contact_sweep.h>

namespace MortarContact
{
  /// A vector in 3d space.
  template <int dim>
  inline Tensor<1, 3>
  in_space(const Tensor<1, dim> &v)
  {
    Tensor<1, 3> result;
    for (unsigned int i = 0; i < dim; ++i)
      result[i] = v[i];
    return result;
  }

  /// Contact forces on the vertices of a pair: function(role, x, force), role 0
  /// secondary. Obstacles have no vertices: @p primary is null.
  template <int dim, class Function>
  void
  for_each_force(const Skin<dim>                              &secondary,
                 const Skin<dim>                              *primary,
                 const typename ContactSweep<dim>::ActivePair &pair,
                 const Function                               &function)
  {
    for (unsigned int side = 0; side < (primary == nullptr ? 1 : 2); ++side)
      {
        const Facet<dim> &facet = (side == 0) ?
                                    secondary.facets[pair.secondary].current :
                                    primary->facets[pair.primary].current;
        for (unsigned int a = 0; a < facet.n_vertices; ++a)
          {
            Tensor<1, dim> force;
            for (unsigned int i = 0; i < dim; ++i)
              force[i] =
                -pair.block
                   .residual[side * max_facet_components<dim> + a * dim + i];
            function(side, in_space(facet.x[a]), in_space(force));
          }
      }
  }
} // namespace MortarContact

#endif
