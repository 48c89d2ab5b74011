// SPDX-License-Identifier: LGPL-2.1-or-later

// Overlaps cut into triangles: areas against the polygon's, and quadrature that
// does not notice on which side of a nearly common edge a vertex lies.

#include <mortar_contact/mortar/segmentation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
  using namespace dealii;
  using namespace MortarContact;

  PlanePoint<3>
  point(const double x, const double y)
  {
    PlanePoint<3> result;
    result[0] = x;
    result[1] = y;
    return result;
  }


  Overlap<3>
  polygon(const std::vector<PlanePoint<3>> &vertices)
  {
    Overlap<3> overlap;
    overlap.n_vertices = vertices.size();
    for (unsigned int k = 0; k < vertices.size(); ++k)
      overlap.vertices[k].y = vertices[k];
    return overlap;
  }


  /// Integral by the three-point rule (mid-sides) on each triangle.
  template <typename Function>
  double
  integral(const MortarSegments<3> &segments, const Function &function)
  {
    double sum = 0.;
    for (unsigned int s = 0; s < segments.n_simplices(); ++s)
      for (unsigned int k = 0; k < 3; ++k)
        sum += segments.area(s) / 3. *
               function(0.5 * (segments.corner(s, k) +
                               segments.corner(s, (k + 1) % 3)));
    return sum;
  }
} // namespace


TEST(Segmentation, AVertexOnANearlyCommonEdgeMayBeAnywhere)
{
  // a square whose upper edge two facets share up to an angle of 1e-6: their
  // edges cross at s
  const auto square = [](const double s) {
    return MortarSegments<3>(polygon({point(0., 0.),
                                      point(1., 0.),
                                      point(1., 1.),
                                      point(s, 1. + 1e-6),
                                      point(0., 1.)}));
  };
  // open left of a line: a kink, as where contact begins
  const auto kink = [](const PlanePoint<3> &y) {
    return std::max(0., y[0] + 0.3 * y[1] - 0.61);
  };
  const double here = integral(square(0.5), kink);
  for (const double s : {0.01, 0.2, 0.35, 0.8, 0.99})
    EXPECT_NEAR(integral(square(s), kink), here, 1e-6) << s;
}


TEST(Segmentation, AreasArePositiveAndSumUp)
{
  // polygons on ellipses, down to slivers with all vertices nearly in line
  std::mt19937                           random(3);
  std::uniform_real_distribution<double> unit(0., 1.);
  for (unsigned int sample = 0; sample < 2000; ++sample)
    {
      const double        flatness = std::pow(10., -4. * unit(random));
      std::vector<double> angles(3 + sample % 6);
      for (double &a : angles)
        a = 2. * numbers::PI * unit(random);
      std::sort(angles.begin(), angles.end());
      std::vector<PlanePoint<3>> vertices;
      for (const double a : angles)
        vertices.push_back(point(std::cos(a), flatness * std::sin(a)));
      double area = 0.;
      for (unsigned int k = 0; k < vertices.size(); ++k)
        {
          const PlanePoint<3> &a = vertices[k];
          const PlanePoint<3> &b = vertices[(k + 1) % vertices.size()];
          area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
        }
      const MortarSegments<3> segments(polygon(vertices));
      double                  sum = 0.;
      for (unsigned int s = 0; s < segments.n_simplices(); ++s)
        {
          EXPECT_GT(segments.area(s), -1e-14 * flatness) << sample;
          sum += segments.area(s);
        }
      EXPECT_NEAR(sum, area, 1e-13 * flatness) << sample;
    }
}
