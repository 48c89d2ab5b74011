// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/geometry/projection.h>
#include <mortar_contact/geometry/simplex_rule.h>
#include <mortar_contact/state/contact_history.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace MortarContact;

TEST(SimplexRule, IntegratesMonomialsUpToItsDegree)
{
  // int x^i y^j over the unit triangle = i! j! / (i + j + 2)!; weights sum to 1
  for (unsigned int degree = 2; degree <= 6; ++degree)
    for (unsigned int i = 0; i <= degree; ++i)
      for (unsigned int j = 0; i + j <= degree; ++j)
        {
          double sum = 0.;
          for (const auto &q : simplex_rule<3>(degree))
            sum += 0.5 * q.weight * std::pow(q.lambda[1], i) *
                   std::pow(q.lambda[2], j);
          EXPECT_NEAR(sum,
                      std::tgamma(i + 1.) * std::tgamma(j + 1.) /
                        std::tgamma(i + j + 3.),
                      1e-14);
        }
  for (unsigned int degree = 2; degree <= 6; ++degree)
    for (unsigned int i = 0; i <= degree; ++i)
      {
        double sum = 0.;
        for (const auto &q : simplex_rule<2>(degree))
          sum += q.weight * std::pow(q.lambda[1], i);
        EXPECT_NEAR(sum, 1. / (i + 1.), 1e-14);
      }
}

TEST(SimplexRule, PointsLieInsideWithPositiveWeights)
{
  for (unsigned int degree = 2; degree <= 6; ++degree)
    for (const auto &q : simplex_rule<3>(degree))
      {
        EXPECT_GT(q.weight, 0.);
        for (const double l : q.lambda)
          EXPECT_GT(l, 0.);
      }
}

TEST(InverseMap, RecoversThePointItCameFrom)
{
  const PlaneFacet<3> y = {{PlanePoint<3>({0.1, 0.}),
                            PlanePoint<3>({1.2, 0.2}),
                            PlanePoint<3>({0.9, 1.4}),
                            PlanePoint<3>({-0.3, 0.8})}};
  for (const unsigned int n : {3u, 4u})
    for (const double a : {-0.3, 0., 0.2, 1., 1.4})
      for (const double b : {-0.2, 0.5, 1.})
        {
          const PlanePoint<3> xi({a, b});
          const auto          N = shape_values<3>(n, xi);
          PlanePoint<3>       at;
          for (unsigned int v = 0; v < n; ++v)
            at += N[v] * y[v];
          const auto found = inverse_map<3>(n, y, at);
          ASSERT_TRUE(found);
          EXPECT_LT((*found - xi).norm(), 1e-12);
        }
}

TEST(InverseMap, RefusesFacetsWithoutArea)
{
  const PlaneFacet<3> line = {{PlanePoint<3>({0., 0.}),
                               PlanePoint<3>({1., 0.}),
                               PlanePoint<3>({2., 0.}),
                               PlanePoint<3>({3., 0.})}};
  EXPECT_FALSE(inverse_map<3>(3, line, PlanePoint<3>({0.5, 0.})));
  EXPECT_FALSE(inverse_map<3>(4, line, PlanePoint<3>({0.5, 0.})));
}

TEST(MaterialPoints, ExtrapolationIsExactForLinearAndBilinearFields)
{
  for (const unsigned int n : {3u, 4u})
    {
      const auto field = [&](const PlanePoint<3> &p) {
        return 1. + 2. * p[0] - 3. * p[1] + (n == 4 ? 0.7 * p[0] * p[1] : 0.);
      };
      VertexValues<3> values = {};
      const auto      points = material_points<3>(n);
      for (unsigned int q = 0; q < points.size(); ++q)
        values[q] = field(points[q]);
      const auto at_vertices = extrapolate_to_vertices<3>(n, values);
      for (unsigned int a = 0; a < n; ++a)
        EXPECT_NEAR(at_vertices[a], field(reference_vertex<3>(n, a)), 1e-14);
    }
}
