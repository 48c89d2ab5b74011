// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_host_rigid_body_h
#define mortar_contact_host_rigid_body_h

#include <mortar_contact/geometry/facet.h>
#include <mortar_contact/geometry/obstacle.h>

#include <deal.II/grid/tria.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace MortarContact
{
  /**
   * A rigid body: a smooth surface, or facets, that move as a function of time.
   * It has no dofs. Several interfaces may share one.
   *
   * With facets it may be secondary or primary, with a smooth surface primary
   * only. Facets are one-sided: their normals point out of the body.
   */
  template <int dim>
  class RigidBody
  {
  public:
    /// A body with a smooth surface.
    RigidBody(const std::string &name, std::unique_ptr<Obstacle<dim>> surface);

    /**
     * A body of facets.
     * @param vertices Positions [m].
     * @param facets   Vertices of each facet, in the order of Facet.
     */
    RigidBody(const std::string                            &name,
              const std::vector<Tensor<1, dim>>            &vertices,
              const std::vector<std::vector<unsigned int>> &facets);

    /// Motion over time [s]; none: at rest.
    std::function<RigidMotion<dim>(const double)> prescribed;

    /// Go where the motion says; called by the interfaces.
    void
    move(const double time);

    /// Accept the present place as that at the end of the step.
    void
    commit();

    const RigidMotion<dim> &
    motion() const
    {
      return present;
    }

    /// The motion at the end of the last accepted step.
    const RigidMotion<dim> &
    motion_before() const
    {
      return before;
    }

    /// Continue from a saved state.
    void
    restore(const RigidMotion<dim> &present, const RigidMotion<dim> &before);

    /// Turn a facet over.
    void
    turn(const unsigned int facet);

    const std::string                      name;
    const std::unique_ptr<Obstacle<dim>>   surface; ///< Null: facets.
    const std::vector<Tensor<1, dim>>      vertices;
    std::vector<std::vector<unsigned int>> facets;

  private:
    RigidMotion<dim> present, before;
  };

  /// Vertices and facets of a surface mesh, for RigidBody. Quadrilaterals and
  /// triangles (lines in 2d), oriented as the cells are.
  template <int dim>
  void
  facets_of(const Triangulation<dim - 1, dim>      &mesh,
            std::vector<Tensor<1, dim>>            &vertices,
            std::vector<std::vector<unsigned int>> &facets);
} // namespace MortarContact

#endif
