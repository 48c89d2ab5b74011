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
   * A rigid body: a smooth surface, or facets. It moves as a function of time
   * and has no dofs; or its motion is made of dofs of the host, see set_dofs().
   * Several interfaces may share one.
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

    /// Translations and rotations: 3 in 2d, 6 in 3d.
    static constexpr unsigned int n_dofs = (dim == 2) ? 3 : 6;
    /// 1 (2d) or 3.
    static constexpr unsigned int n_rotations = n_dofs - dim;

    /// Motion over time [s]; none: at rest. With dofs: the place that they
    /// start from, at time 0.
    std::function<RigidMotion<dim>(const double)> prescribed;

    /**
     * Let dofs move the body: displacement u of the point @p centre of the
     * body in its starting place, then the rotation as @p length times a vector
     * [m] that the steps add up: within a step R = exp(theta - theta_n) R_n.
     * A length makes all entries of the host's vectors forces and lengths.
     */
    void
    set_dofs(const std::array<types::global_dof_index, n_dofs> &dofs,
             const Tensor<1, dim>                              &centre,
             const double                                       length);

    /// Whether forces decide some of its motions.
    bool
    has_dofs() const
    {
      return !own_dofs.empty();
    }

    /// Global numbers; none or n_dofs.
    const std::vector<types::global_dof_index> &
    dofs() const
    {
      return own_dofs;
    }

    /// Go where the motion says; called by the interfaces.
    void
    move(const double time);

    /// Go where the values of the dofs say.
    void
    move_to(const std::array<double, n_dofs> &values);

    /// Point that the body turns about, present place.
    Tensor<1, dim>
    turning_point() const
    {
      return centre + displacement;
    }

    /// Its displacement since the start [m].
    const Tensor<1, dim> &
    displacement_of_centre() const
    {
      return displacement;
    }

    /// Its rotation vector, summed up over the steps [rad]; 2d: last component.
    const Tensor<1, 3> &
    rotation_vector() const
    {
      return angle;
    }

    /// Spin by a change of the rotational dofs: [spin component][dof], over the
    /// length of set_dofs().
    std::array<std::array<double, n_rotations>, n_rotations>
    spin_by_dofs() const;

    /// Accept the present place as that at the end of the step.
    void
    commit();

    /// The present one.
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


    /// Turn a facet over.
    void
    turn(const unsigned int facet);

    /// In reports, messages and files.
    const std::string                    name;
    const std::unique_ptr<Obstacle<dim>> surface; ///< Null: facets.
    /// Of a mesh, in the body's own coordinates [m]; none of a smooth surface.
    const std::vector<Tensor<1, dim>> vertices;
    /// Numbers of their vertices, counter-clockwise from outside.
    std::vector<std::vector<unsigned int>> facets;

    /// The complete state.
    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &present &before &displacement &turned &angle &last_angle;
    }

  private:
    RigidMotion<dim> present, before;

    // with dofs
    std::vector<types::global_dof_index> own_dofs;
    RigidMotion<dim>                     start;
    Tensor<1, dim>                       centre, displacement;
    double                               length = 1.;
    Tensor<2, dim> turned = RigidMotion<dim>().rotation; ///< R_n
    Tensor<1, 3>   angle, last_angle; ///< theta, theta_n [rad]; 2d: last.
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
