// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_geometry_obstacle_h
#define mortar_contact_geometry_obstacle_h

#include <mortar_contact/geometry/rigid_motion.h>

#include <deal.II/base/symmetric_tensor.h>

#include <array>
#include <memory>
#include <optional>

namespace MortarContact
{
  /// A smooth surface about one of its points, in any coordinates eta.
  template <int dim>
  struct SurfacePoint
  {
    Tensor<1, dim>                      x;        ///< The point [m]
    std::array<Tensor<1, dim>, dim - 1> tangents; ///< x,b; outward by product.
    /// Second derivatives x,bc.
    std::array<std::array<Tensor<1, dim>, dim - 1>, dim - 1> second;
    /// Where the material point eta was at the end of the last accepted step,
    /// for friction.
    Tensor<1, dim> before;
    /// Its derivatives by eta.
    std::array<Tensor<1, dim>, dim - 1> before_tangents;
  };

  /**
   * Shape of a rigid body as F(X) = 0, negative inside, in the body's own
   * coordinates.
   */
  template <int dim>
  class ImplicitShape
  {
  public:
    /// F and its derivatives by X at one place.
    struct Value
    {
      double                  value = 0.; ///< F, in the units of the shape.
      Tensor<1, dim>          gradient;   ///< dF/dX
      SymmetricTensor<2, dim> hessian;    ///< d2F/dX2
    };

    virtual ~ImplicitShape() = default;

    /// F and its derivatives at @p X [m].
    virtual Value
    evaluate(const Tensor<1, dim> &X) const = 0;

    /// For shapes that change with time [s].
    virtual void
    set_time(const double)
    {}
  };

  /// Half space below X_last = 0.
  template <int dim>
  std::unique_ptr<ImplicitShape<dim>>
  plane_shape();

  /// Ball (disc in 2d) about the origin.
  template <int dim>
  std::unique_ptr<ImplicitShape<dim>>
  ball_shape(const double radius);

  /// Box about the origin, with sharp edges.
  template <int dim>
  std::unique_ptr<ImplicitShape<dim>>
  box_shape(const Tensor<1, dim> &half_widths);

  /// Ellipsoid (ellipse) about the origin.
  template <int dim>
  std::unique_ptr<ImplicitShape<dim>>
  ellipsoid_shape(const Tensor<1, dim> &semi_axes);

  /// Cylinder along the last axis, endless for length 0.
  std::unique_ptr<ImplicitShape<3>>
  cylinder_shape(const double radius, const double length);

  /// Endless cone, apex at the origin, opening to negative X_last.
  /// @param half_angle [rad]
  std::unique_ptr<ImplicitShape<3>>
  cone_shape(const double half_angle);

  /// Torus around the last axis.
  std::unique_ptr<ImplicitShape<3>>
  torus_shape(const double ring_radius, const double tube_radius);

  /// A formula in x, y, z, t and pi; derivatives by differences over
  /// @p step, a small length. @throw ExcMessage if it is none.
  template <int dim>
  std::unique_ptr<ImplicitShape<dim>>
  formula_shape(const std::string &formula, const double step);


  /**
   * The smooth surface of a rigid body, where it meets a line. Only primaries
   * can be obstacles: the points are on the other side.
   */
  template <int dim>
  class Obstacle
  {
  public:
    virtual ~Obstacle() = default;

    /**
     * The point x - d n where the line through @p x along the unit vector
     * @p n enters the body, nearest to x as the search finds it.
     * @return Nothing if there is none with |d| <= @p range and an outward
     * normal that faces n.
     */
    std::optional<SurfacePoint<dim>>
    meet(const Tensor<1, dim> &x,
         const Tensor<1, dim> &n,
         const double          range) const;

    /// Whether a ball about @p x of radius @p r is surely apart from the body.
    bool
    is_far(const Tensor<1, dim> &x, const double r) const
    {
      return is_far_in_body(motion.origin(x), r);
    }

    /// For surfaces that change with time [s].
    virtual void
    set_time(const double)
    {}

    RigidMotion<dim> motion; ///< Present.
    RigidMotion<dim> before; ///< Of the last accepted step.

  protected:
    /// In the body's own coordinates; tangents with their second derivatives.
    virtual std::optional<SurfacePoint<dim>>
    meet_in_body(const Tensor<1, dim> &X,
                 const Tensor<1, dim> &N,
                 const double          range) const = 0;

    /// is_far() in the body's own coordinates.
    virtual bool
    is_far_in_body(const Tensor<1, dim> &X, const double r) const = 0;
  };


  /// Exact: F(X) = 0.
  template <int dim>
  class ImplicitObstacle : public Obstacle<dim>
  {
  public:
    /// The body is where @p shape is negative.
    explicit ImplicitObstacle(std::unique_ptr<ImplicitShape<dim>> shape)
      : shape(std::move(shape))
    {}

    /// Of the shape [s].
    void
    set_time(const double time) override
    {
      shape->set_time(time);
    }

  protected:
    std::optional<SurfacePoint<dim>>
    meet_in_body(const Tensor<1, dim> &X,
                 const Tensor<1, dim> &N,
                 const double          range) const override;

    /// Estimated from F and its gradient.
    bool
    is_far_in_body(const Tensor<1, dim> &X, const double r) const override;

  private:
    const std::unique_ptr<ImplicitShape<dim>> shape;
  };
} // namespace MortarContact

#endif
