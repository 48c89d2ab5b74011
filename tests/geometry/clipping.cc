// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/geometry/clipping.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace MortarContact;

namespace
{
  PlaneFacet<3>
  square(const double x,
         const double y,
         const double size,
         const double angle = 0.)
  {
    PlaneFacet<3> result;
    const double  corners[4][2] = {{-.5, -.5}, {.5, -.5}, {.5, .5}, {-.5, .5}};
    for (unsigned int a = 0; a < 4; ++a)
      {
        const double u = size * corners[a][0], v = size * corners[a][1];
        result[a][0] = x + std::cos(angle) * u - std::sin(angle) * v;
        result[a][1] = y + std::sin(angle) * u + std::cos(angle) * v;
      }
    return result;
  }

  double
  overlap_area(const unsigned int   n_s,
               const PlaneFacet<3> &s,
               const unsigned int   n_p,
               const PlaneFacet<3> &p)
  {
    double     sum      = 0.;
    const auto pieces_s = convex_pieces<3>(n_s, s);
    const auto pieces_p = convex_pieces<3>(n_p, p);
    for (unsigned int i = 0; i < pieces_s.n_pieces; ++i)
      for (unsigned int j = 0; j < pieces_p.n_pieces; ++j)
        sum +=
          area(clip<3>(s, pieces_s.pieces[i], p, pieces_p.pieces[j], 1e-13));
    return sum;
  }
} // namespace


TEST(Clipping, KnownAreas)
{
  const auto unit = square(0., 0., 1.);
  EXPECT_NEAR(overlap_area(4, unit, 4, unit), 1., 1e-14);
  EXPECT_EQ(overlap_area(4, unit, 4, square(3., 0., 1.)), 0.);
  EXPECT_LT(std::abs(overlap_area(4, unit, 4, square(1., 0., 1.))), 1e-14);
  // a square of diagonal sqrt(2), turned: a regular octagon
  EXPECT_NEAR(overlap_area(4, unit, 4, square(0., 0., 1., numbers::PI / 4.)),
              2. * (std::sqrt(2.) - 1.),
              1e-13);
  // orientation of the other facet does not matter
  auto reversed = unit;
  std::swap(reversed[1], reversed[3]);
  EXPECT_NEAR(overlap_area(4, unit, 4, reversed), 1., 1e-14);
}


TEST(Clipping, CornersAndEdgesThatAlmostCoincideLoseNoArea)
{
  // BENCHMARKS X13: sum over a grid of facets is the area of the secondary
  for (const double offset : {0., 1e-16, 1e-13, 1e-12, 1e-8})
    for (const unsigned int n : {1u, 2u, 3u, 4u})
      {
        const auto s   = square(0., 0., 1.);
        double     sum = 0.;
        for (unsigned int i = 0; i < n + 2; ++i)
          for (unsigned int j = 0; j < n + 2; ++j)
            sum += overlap_area(4,
                                s,
                                4,
                                square(-0.5 + (i - 0.5) / n + offset,
                                       -0.5 + (j - 0.5) / n - offset,
                                       1. / n));
        EXPECT_NEAR(sum, 1., 1e-12) << offset << " " << n;
      }
}


TEST(Clipping, AnyMeshThatCoversAFacetGivesItsArea)
{
  // THEORY T6, on a turned, distorted grid of quadrilaterals and triangles
  std::mt19937                           rng(3);
  std::uniform_real_distribution<double> u(-1., 1.);
  for (const double angle : {0., 0.2618, 0.5236, 0.7854})
    {
      const int                              n = 7;
      std::vector<std::vector<Tensor<1, 2>>> grid(n + 1,
                                                  std::vector<Tensor<1, 2>>(n +
                                                                            1));
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
          {
            const double x = (i - n / 2.) * 0.3 + 0.04 * u(rng);
            const double y = (j - n / 2.) * 0.3 + 0.04 * u(rng);
            grid[i][j][0]  = std::cos(angle) * x - std::sin(angle) * y;
            grid[i][j][1]  = std::sin(angle) * x + std::cos(angle) * y;
          }
      const auto s   = square(0.05, 0.02, 1., 0.1);
      double     sum = 0.;
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          if ((i + j) % 2 == 0)
            sum += overlap_area(4,
                                s,
                                4,
                                {{grid[i][j],
                                  grid[i + 1][j],
                                  grid[i + 1][j + 1],
                                  grid[i][j + 1]}});
          else
            {
              sum += overlap_area(
                4,
                s,
                3,
                {{grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], {}}});
              sum += overlap_area(
                4,
                s,
                3,
                {{grid[i][j], grid[i + 1][j + 1], grid[i][j + 1], {}}});
            }
      EXPECT_NEAR(sum, 1., 1e-12);
    }
}


TEST(Clipping, ReentrantFacetsAreCutFoldedOnesRefused)
{
  PlaneFacet<3> dart = square(0., 0., 1.);
  dart[2][0]         = -0.2;
  dart[2][1]         = -0.2;
  EXPECT_EQ(convex_pieces<3>(4, dart).n_pieces, 2u);
  // shoelace of the dart: 0.3
  EXPECT_NEAR(overlap_area(4, dart, 4, square(0., 0., 1.)), 0.3, 1e-14);
  PlaneFacet<3> folded = square(0., 0., 1.);
  std::swap(folded[1], folded[2]);
  EXPECT_EQ(convex_pieces<3>(4, folded).n_pieces, 0u);
  EXPECT_EQ(convex_pieces<3>(3, PlaneFacet<3>()).n_pieces, 0u);
}


TEST(Clipping, IntervalsIn2d)
{
  PlaneFacet<2> s, p;
  s[0][0]      = 0.;
  s[1][0]      = 1.;
  p[0][0]      = 1.5;
  p[1][0]      = 0.25;
  const auto o = clip<2>(s,
                         convex_pieces<2>(2, s).pieces[0],
                         p,
                         convex_pieces<2>(2, p).pieces[0],
                         0.);
  EXPECT_NEAR(area(o), 0.75, 1e-15);
}
