// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/geometry/smooth_facets.h>
#include <mortar_contact/laws/paper_law.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include "../support/facet_pair.h"

using namespace MortarContact;
using namespace Test;

namespace
{
  Tensor<1, 3>
  vector(const double x, const double y, const double z)
  {
    return Tensor<1, 3>({x, y, z});
  }

  struct Named
  {
    const char                       *name;
    std::unique_ptr<ImplicitShape<3>> shape;
    Tensor<1, 3> at, towards; ///< A point near it, and a line to it.
  };

  std::vector<Named>
  shapes()
  {
    std::vector<Named> all;
    all.push_back(
      {"plane", plane_shape<3>(), vector(.1, .2, .02), vector(.1, .2, -1)});
    all.push_back(
      {"ball", ball_shape<3>(1.), vector(.6, .1, .85), vector(-.5, 0, -.9)});
    all.push_back({"box",
                   box_shape<3>(vector(1, 2, 3)),
                   vector(1.02, .3, .4),
                   vector(-1, .2, .1)});
    all.push_back({"ellipsoid",
                   ellipsoid_shape<3>(vector(1, 2, .5)),
                   vector(.3, .4, .5),
                   vector(-.1, .1, -1)});
    all.push_back({"cylinder",
                   cylinder_shape(.5, 0.),
                   vector(.4, .33, .7),
                   vector(-1, -.7, .2)});
    all.push_back(
      {"cone", cone_shape(.6), vector(.5, .2, -.7), vector(-1, -.3, -.4)});
    all.push_back(
      {"torus", torus_shape(1., .3), vector(.9, .3, .32), vector(.1, .1, -1)});
    all.push_back({"formula",
                   formula_shape<3>("x^2 + 2*y^2 + z^4 - 1", 1e-3),
                   vector(.5, .4, .8),
                   vector(-.3, -.2, -1)});
    return all;
  }
} // namespace


TEST(Obstacle, DerivativesOfShapesAgreeWithDifferences)
{
  for (const Named &s : shapes())
    {
      const auto   v = s.shape->evaluate(s.at);
      const double h = 1e-5;
      for (unsigned int i = 0; i < 3; ++i)
        {
          Tensor<1, 3> e;
          e[i]             = h;
          const auto plus  = s.shape->evaluate(s.at + e);
          const auto minus = s.shape->evaluate(s.at - e);
          EXPECT_NEAR(v.gradient[i],
                      (plus.value - minus.value) / (2. * h),
                      1e-8)
            << s.name;
          for (unsigned int j = 0; j < 3; ++j)
            EXPECT_NEAR(v.hessian[i][j],
                        (plus.gradient[j] - minus.gradient[j]) / (2. * h),
                        1e-5)
              << s.name;
        }
    }
}


TEST(Obstacle, LinesMeetTheSurfaceAndItsTangentsAreTheSurfaces)
{
  for (Named &s : shapes())
    {
      const std::string       name  = s.name;
      const ImplicitShape<3> *shape = s.shape.get();
      ImplicitObstacle<3>     body(std::move(s.shape));
      body.motion.rotation    = rotation(0.4, 0.2);
      body.motion.translation = vector(1., -2., 3.);
      const Tensor<1, 3> x    = body.motion.place(s.at);
      const Tensor<1, 3> n =
        body.motion.rotation * (s.towards / s.towards.norm());
      const auto hit = body.meet(x, n, 0.5);
      ASSERT_TRUE(hit) << name;
      // on the surface, on the line, normal against the line
      EXPECT_NEAR(shape->evaluate(body.motion.origin(hit->x)).value, 0., 1e-13)
        << name;
      EXPECT_LT(cross_product_3d(hit->x - x, n).norm(), 1e-13) << name;
      const Tensor<1, 3> nu =
        cross_product_3d(hit->tangents[0], hit->tangents[1]);
      EXPECT_LT(nu * n, 0.) << name;
      // second order: x + t s + second s^2/2 leaves F at zero to third order
      double off[2];
      for (unsigned int k = 0; k < 2; ++k)
        {
          const double       e = (k == 0) ? 0.02 : 0.01;
          const Tensor<1, 3> y = hit->x + e * hit->tangents[0] -
                                 0.5 * e * hit->tangents[1] +
                                 0.5 * e * e *
                                   (hit->second[0][0] - hit->second[0][1] +
                                    0.25 * hit->second[1][1]);
          off[k] = std::abs(shape->evaluate(body.motion.origin(y)).value);
        }
      EXPECT_LT(off[1], std::max(0.2 * off[0], 1e-12)) << name;
      // away from it there is nothing
      EXPECT_FALSE(body.meet(x, -n, 0.5)) << name;
    }
}


// Reference: central differences of the forces; friction included.
TEST(Obstacle, TangentOnAnObstacleIsTheDerivativeOfTheForces)
{
  const PaperLaw        law(PressureCurve::parabola_linear, 0.1, 5.);
  const CoulombFriction coulomb(0.4, 0.4, 0.);
  for (const bool smooth_facets : {false, true})
    for (const FrictionLaw *friction :
         {(const FrictionLaw *)nullptr, (const FrictionLaw *)&coulomb})
      {
        std::unique_ptr<Obstacle<3>> body;
        if (!smooth_facets)
          body = std::make_unique<ImplicitObstacle<3>>(
            ellipsoid_shape<3>(vector(1., 0.8, 0.6)));
        else
          {
            // an octahedron of the same size, smoothed
            std::vector<Facet<3>> facets;
            for (const double sx : {-1., 1.})
              for (const double sy : {-1., 1.})
                for (const double sz : {-1., 1.})
                  {
                    Facet<3> f;
                    f.n_vertices = 3;
                    f.x[0]       = vector(sx, 0, 0);
                    f.x[1]       = vector(0, .8 * sy, 0);
                    f.x[2]       = vector(0, 0, .6 * sz);
                    if (sx * sy * sz < 0.)
                      std::swap(f.x[1], f.x[2]);
                    facets.push_back(f);
                  }
            body = std::make_unique<SmoothFacets<3>>(facets, 2.);
          }
        const double top         = smooth_facets ? 0.42 : 0.5;
        body->motion.rotation    = rotation(0.3, 0.1);
        body->before.rotation    = rotation(0.28, 0.1);
        body->before.translation = vector(0.01, -0.02, 0.);

        Pair3d pair(4, 4, 0., 0., 2);
        // the secondary looks down on the body
        Facet<3> s = pair.secondary.current;
        for (auto &x : s.x)
          {
            x    = 0.25 * x;
            x[1] = -x[1];
            x[2] = -x[2] + top;
            x += vector(.2, .15, 0.);
          }
        pair.secondary.reference = s;
        FacetSlip<3> slip;
        slip.before = s;
        const SecondaryFrame<3> frame(s);
        slip.normal = frame.normal;
        slip.basis  = frame.basis;
        SecondaryState<3> state;
        state.slip = (friction != nullptr) ? &slip : nullptr;

        KernelOptions options;
        options.integration.rule = Integration::Rule::points;
        const PairKernel<3> kernel(law, friction, options);
        const auto          evaluate =
          [&](const Facet<3> &at, const Facet<3> &, const bool tangent) {
            ContactFacet<3> secondary = pair.secondary;
            secondary.current         = at;
            const SecondaryFrame<3> f(at);
            PairBlock<3>            block;
            for (const auto &[xi, w] : kernel.fixed_points(4))
              {
                const auto hit =
                  body->meet(interpolate(at, shape_values<3>(4, xi)),
                             f.normal,
                             1.);
                if (!hit)
                  continue;
                PrimaryPoint<3> p;
                static_cast<SurfacePoint<3> &>(p) = *hit;
                kernel.add_fixed_point(
                  f, secondary, state, p, xi, w, tangent, block);
              }
            return block;
          };
        const auto block = evaluate(s, s, true);
        ASSERT_TRUE(block.is_active()) << smooth_facets;
        EXPECT_LT(tangent_error<3>(evaluate, s, s), 1e-6)
          << smooth_facets << (friction != nullptr);
      }
}


// Nagata 2005: normals of patches on a sphere are right to second order.
TEST(SmoothFacets, SphereIsSmootherThanItsFacets)
{
  double error[2] = {0., 0.}, radius[2] = {0., 0.};
  for (unsigned int level = 0; level < 2; ++level)
    {
      const unsigned int    n = 8 << level;
      std::vector<Facet<3>> facets;
      const auto at = [&](const unsigned int i, const unsigned int j) {
        const double a = 2. * numbers::PI * i / (2. * n);
        const double b = numbers::PI * (0.15 + 0.7 * j / n);
        return vector(std::sin(b) * std::cos(a),
                      std::sin(b) * std::sin(a),
                      std::cos(b));
      };
      for (unsigned int i = 0; i < 2 * n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            Facet<3>           f;
            const unsigned int k = (i + 1) % (2 * n);
            f.x = {{at(i, j), at(i, j + 1), at(k, j + 1), at(k, j)}};
            facets.push_back(f);
          }
      const SmoothFacets<3> body(facets, 1.);
      for (unsigned int i = 0; i < 200; ++i)
        {
          const double       a = 0.0317 * i, b = 1. + 0.003 * i;
          const Tensor<1, 3> r   = vector(std::sin(b) * std::cos(a),
                                        std::sin(b) * std::sin(a),
                                        std::cos(b));
          const auto         hit = body.meet(1.1 * r, -r, 0.5);
          ASSERT_TRUE(hit);
          Tensor<1, 3> nu =
            cross_product_3d(hit->tangents[0], hit->tangents[1]);
          nu /= nu.norm();
          error[level]  = std::max(error[level], (nu - r).norm());
          radius[level] = std::max(radius[level], std::abs(hit->x.norm() - 1.));
        }
    }
  // facets: normals off by up to h/2 = 0.2 and 0.1, of first order
  EXPECT_LT(error[0], 0.05);
  EXPECT_LT(error[1], 0.35 * error[0]);
  EXPECT_LT(radius[1], 0.15 * radius[0]);
}
