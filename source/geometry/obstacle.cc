// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/geometry/obstacle.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/function_parser.h>

#include <cmath>

namespace MortarContact
{
  namespace
  {
    /// Newton steps along a line; smooth shapes need about six.
    constexpr unsigned int max_newton_steps = 40;

    /// Newton has converged when it moves less than this share of the range:
    /// the step after it would be of the size of its square.
    constexpr double newton_tolerance = 1e-10;

    /// Points farther from the body than this times their radius are far; more
    /// than one, since F need not be a distance.
    constexpr double far_factor = 4.;

    /// Gradient and Hessian of a distance from an axis, |P X| with P the
    /// projection on the first @p n components.
    template <int dim>
    typename ImplicitShape<dim>::Value
    distance_in(const Tensor<1, dim> &X, const unsigned int n)
    {
      typename ImplicitShape<dim>::Value v;
      for (unsigned int i = 0; i < n; ++i)
        v.value += X[i] * X[i];
      v.value = std::sqrt(v.value);
      if (v.value == 0.)
        return v; // the axis: no direction; a point there is no contact
      for (unsigned int i = 0; i < n; ++i)
        v.gradient[i] = X[i] / v.value;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j <= i; ++j)
          v.hessian[i][j] =
            ((i == j ? 1. : 0.) - v.gradient[i] * v.gradient[j]) / v.value;
      return v;
    }

    template <int dim>
    class Plane : public ImplicitShape<dim>
    {
    public:
      typename ImplicitShape<dim>::Value
      evaluate(const Tensor<1, dim> &X) const override
      {
        typename ImplicitShape<dim>::Value v;
        v.value             = X[dim - 1];
        v.gradient[dim - 1] = 1.;
        return v;
      }
    };

    template <int dim>
    class Ball : public ImplicitShape<dim>
    {
    public:
      explicit Ball(const double radius)
        : radius(radius)
      {}

      typename ImplicitShape<dim>::Value
      evaluate(const Tensor<1, dim> &X) const override
      {
        auto v = distance_in<dim>(X, dim);
        v.value -= radius;
        return v;
      }

    private:
      const double radius;
    };

    template <int dim>
    class BlockShape : public ImplicitShape<dim>
    {
    public:
      explicit BlockShape(const Tensor<1, dim> &half_widths)
        : half_widths(half_widths)
      {}

      typename ImplicitShape<dim>::Value
      evaluate(const Tensor<1, dim> &X) const override
      {
        unsigned int nearest = 0;
        for (unsigned int i = 1; i < dim; ++i)
          if (std::abs(X[i]) - half_widths[i] >
              std::abs(X[nearest]) - half_widths[nearest])
            nearest = i;
        typename ImplicitShape<dim>::Value v;
        v.value             = std::abs(X[nearest]) - half_widths[nearest];
        v.gradient[nearest] = (X[nearest] < 0.) ? -1. : 1.;
        return v;
      }

    private:
      const Tensor<1, dim> half_widths;
    };

    template <int dim>
    class Ellipsoid : public ImplicitShape<dim>
    {
    public:
      explicit Ellipsoid(const Tensor<1, dim> &semi_axes)
        : semi_axes(semi_axes)
      {}

      typename ImplicitShape<dim>::Value
      evaluate(const Tensor<1, dim> &X) const override
      {
        Tensor<1, dim> scaled;
        for (unsigned int i = 0; i < dim; ++i)
          scaled[i] = X[i] / semi_axes[i];
        auto v = distance_in<dim>(scaled, dim);
        v.value -= 1.;
        for (unsigned int i = 0; i < dim; ++i)
          {
            v.gradient[i] /= semi_axes[i];
            for (unsigned int j = 0; j <= i; ++j)
              v.hessian[i][j] /= semi_axes[i] * semi_axes[j];
          }
        return v;
      }

    private:
      const Tensor<1, dim> semi_axes;
    };

    class CylinderShape : public ImplicitShape<3>
    {
    public:
      CylinderShape(const double radius, const double length)
        : radius(radius)
        , length(length)
      {}

      Value
      evaluate(const Tensor<1, 3> &X) const override
      {
        Value v = distance_in<3>(X, 2);
        v.value -= radius;
        if (length > 0. && std::abs(X[2]) - 0.5 * length > v.value)
          {
            v             = Value();
            v.value       = std::abs(X[2]) - 0.5 * length;
            v.gradient[2] = (X[2] < 0.) ? -1. : 1.;
          }
        return v;
      }

    private:
      const double radius, length;
    };

    class ConeShape : public ImplicitShape<3>
    {
    public:
      explicit ConeShape(const double half_angle)
        : half_angle(half_angle)
      {}

      Value
      evaluate(const Tensor<1, 3> &X) const override
      {
        Value v = distance_in<3>(X, 2);
        v.value = std::cos(half_angle) * v.value + std::sin(half_angle) * X[2];
        v.gradient *= std::cos(half_angle);
        v.gradient[2] = std::sin(half_angle);
        v.hessian *= std::cos(half_angle);
        return v;
      }

    private:
      const double half_angle;
    };

    class TorusShape : public ImplicitShape<3>
    {
    public:
      TorusShape(const double ring_radius, const double tube_radius)
        : ring_radius(ring_radius)
        , tube_radius(tube_radius)
      {}

      Value
      evaluate(const Tensor<1, 3> &X) const override
      {
        // with rho the distance from the axis: s = |(rho - R, X_2)|
        const Value  rho = distance_in<3>(X, 2);
        const double a   = rho.value - ring_radius;
        const double s   = std::sqrt(a * a + X[2] * X[2]);
        Value        v;
        v.value = s - tube_radius;
        if (s == 0.)
          return v;
        v.gradient = a / s * rho.gradient;
        v.gradient[2] += X[2] / s;
        Tensor<1, 3> e;
        e[2]      = 1.;
        v.hessian = a / s * rho.hessian;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j <= i; ++j)
            v.hessian[i][j] += (rho.gradient[i] * rho.gradient[j] +
                                e[i] * e[j] - v.gradient[i] * v.gradient[j]) /
                               s;
        return v;
      }

    private:
      const double ring_radius, tube_radius;
    };

    template <int dim>
    class FormulaShape : public ImplicitShape<dim>
    {
    public:
      FormulaShape(const std::string &formula, const double step)
        : step(step)
        , function(1)
      {
        bool is_formula = true;
        try
          {
            function.initialize((dim == 2) ? "x,y,t" : "x,y,z,t",
                                formula,
                                {{"pi", numbers::PI}},
                                true);
            (void)function.value(Point<dim>());
          }
        catch (const std::exception &)
          {
            is_formula = false;
          }
        AssertThrow(is_formula,
                    ExcMessage("'" + formula + "' is no formula in " +
                               ((dim == 2) ? "x, y" : "x, y, z") +
                               ", t and pi; expected for example x^2 + y^2 - "
                               "1, negative inside the body."));
      }

      void
      set_time(const double time) override
      {
        function.set_time(time);
      }

      typename ImplicitShape<dim>::Value
      evaluate(const Tensor<1, dim> &X) const override
      {
        typename ImplicitShape<dim>::Value v;
        const auto                         at = [&](const unsigned int i,
                            const double       a,
                            const unsigned int j,
                            const double       b) {
          Point<dim> p(X);
          p[i] += a * step;
          p[j] += b * step;
          return function.value(p);
        };
        v.value = at(0, 0., 0, 0.);
        for (unsigned int i = 0; i < dim; ++i)
          {
            // fourth order
            const double p1 = at(i, 1., i, 0.), m1 = at(i, -1., i, 0.);
            const double p2 = at(i, 2., i, 0.), m2 = at(i, -2., i, 0.);
            v.gradient[i]   = (8. * (p1 - m1) - (p2 - m2)) / (12. * step);
            v.hessian[i][i] = (16. * (p1 + m1) - (p2 + m2) - 30. * v.value) /
                              (12. * step * step);
            for (unsigned int j = 0; j < i; ++j)
              v.hessian[i][j] = (at(i, 1., j, 1.) - at(i, 1., j, -1.) -
                                 at(i, -1., j, 1.) + at(i, -1., j, -1.)) /
                                (4. * step * step);
          }
        return v;
      }

    private:
      const double        step;
      FunctionParser<dim> function;
    };
  } // namespace


  template <int dim>
  std::unique_ptr<ImplicitShape<dim>>
  plane_shape()
  {
    return std::make_unique<Plane<dim>>();
  }


  template <int dim>
  std::unique_ptr<ImplicitShape<dim>>
  ball_shape(const double radius)
  {
    return std::make_unique<Ball<dim>>(radius);
  }


  template <int dim>
  std::unique_ptr<ImplicitShape<dim>>
  box_shape(const Tensor<1, dim> &half_widths)
  {
    return std::make_unique<BlockShape<dim>>(half_widths);
  }


  template <int dim>
  std::unique_ptr<ImplicitShape<dim>>
  ellipsoid_shape(const Tensor<1, dim> &semi_axes)
  {
    return std::make_unique<Ellipsoid<dim>>(semi_axes);
  }


  std::unique_ptr<ImplicitShape<3>>
  cylinder_shape(const double radius, const double length)
  {
    return std::make_unique<CylinderShape>(radius, length);
  }


  std::unique_ptr<ImplicitShape<3>>
  cone_shape(const double half_angle)
  {
    return std::make_unique<ConeShape>(half_angle);
  }


  std::unique_ptr<ImplicitShape<3>>
  torus_shape(const double ring_radius, const double tube_radius)
  {
    return std::make_unique<TorusShape>(ring_radius, tube_radius);
  }


  template <int dim>
  std::unique_ptr<ImplicitShape<dim>>
  formula_shape(const std::string &formula, const double step)
  {
    return std::make_unique<FormulaShape<dim>>(formula, step);
  }


  template <int dim>
  std::optional<SurfacePoint<dim>>
  Obstacle<dim>::meet(const Tensor<1, dim> &x,
                      const Tensor<1, dim> &n,
                      const double          range) const
  {
    auto point =
      meet_in_body(motion.origin(x), transpose(motion.rotation) * n, range);
    if (!point)
      return {};
    point->before = before.place(point->x);
    point->x      = motion.place(point->x);
    for (unsigned int b = 0; b < dim - 1; ++b)
      {
        point->before_tangents[b] = before.rotation * point->tangents[b];
        point->tangents[b]        = motion.rotation * point->tangents[b];
        for (unsigned int c = 0; c < dim - 1; ++c)
          point->second[b][c] = motion.rotation * point->second[b][c];
      }
    return point;
  }


  template <int dim>
  bool
  ImplicitObstacle<dim>::is_far_in_body(const Tensor<1, dim> &X,
                                        const double          r) const
  {
    // F is a distance, or grows about as fast as its gradient says
    const auto v = shape->evaluate(X);
    return v.value > far_factor * v.gradient.norm() * r;
  }


  template <int dim>
  std::optional<SurfacePoint<dim>>
  ImplicitObstacle<dim>::meet_in_body(const Tensor<1, dim> &X,
                                      const Tensor<1, dim> &N,
                                      const double          range) const
  {
    // Step 1: F(X - d N) = 0 by Newton's method.
    typename ImplicitShape<dim>::Value v;
    double                             d         = 0.;
    bool                               converged = false;
    for (unsigned int i = 0; i < max_newton_steps && !converged; ++i)
      {
        v                  = shape->evaluate(X - d * N);
        const double slope = -(v.gradient * N);
        // the surface must face N; NaN does not
        if (!(slope > 0.))
          return {};
        // F grows along -N when d grows inwards: F < 0 inside
        const double step = -v.value / slope;
        d += std::min(std::max(step, -range), range);
        if (!(std::abs(d) <= 2. * range))
          return {};
        converged = std::abs(step) <= newton_tolerance * range;
      }
    if (!converged || std::abs(d) > range)
      return {};
    v = shape->evaluate(X - d * N);

    // Step 2: the surface there, along orthonormal tangents: F = 0 twice
    // differentiated gives grad F . x,bc = -x,b . H x,c.
    const double                        slope = v.gradient.norm();
    const Tensor<1, dim>                nu    = v.gradient / slope;
    std::array<Tensor<1, dim>, dim - 1> t;
    if constexpr (dim == 2)
      t[0] = -cross_product_2d(nu);
    else
      {
        unsigned int smallest = 0;
        for (unsigned int i = 1; i < dim; ++i)
          if (std::abs(nu[i]) < std::abs(nu[smallest]))
            smallest = i;
        Tensor<1, dim> e;
        e[smallest] = 1.;
        t[0]        = cross_product_3d(nu, e);
        t[0] /= t[0].norm();
        t[1] = cross_product_3d(nu, t[0]);
      }
    SurfacePoint<dim> point;
    point.x        = X - d * N;
    point.tangents = t;
    for (unsigned int b = 0; b < dim - 1; ++b)
      for (unsigned int c = 0; c < dim - 1; ++c)
        point.second[b][c] = -(t[b] * (v.hessian * t[c])) / slope * nu;
    return point;
  }


  template class Obstacle<2>;
  template class Obstacle<3>;
  template class ImplicitObstacle<2>;
  template class ImplicitObstacle<3>;
  template std::unique_ptr<ImplicitShape<2>>
  plane_shape<2>();
  template std::unique_ptr<ImplicitShape<3>>
  plane_shape<3>();
  template std::unique_ptr<ImplicitShape<2>>
  ball_shape<2>(const double);
  template std::unique_ptr<ImplicitShape<3>>
  ball_shape<3>(const double);
  template std::unique_ptr<ImplicitShape<2>>
  box_shape<2>(const Tensor<1, 2> &);
  template std::unique_ptr<ImplicitShape<3>>
  box_shape<3>(const Tensor<1, 3> &);
  template std::unique_ptr<ImplicitShape<2>>
  ellipsoid_shape<2>(const Tensor<1, 2> &);
  template std::unique_ptr<ImplicitShape<3>>
  ellipsoid_shape<3>(const Tensor<1, 3> &);
  template std::unique_ptr<ImplicitShape<2>>
  formula_shape<2>(const std::string &, const double);
  template std::unique_ptr<ImplicitShape<3>>
  formula_shape<3>(const std::string &, const double);
} // namespace MortarContact
