// SPDX-License-Identifier: LGPL-2.1-or-later

// Meshes far from each other and facets of any shape: BENCHMARKS.md X5, X6,
// X7, X12, X13, X25. Reference: uniform stress, areas, continuity.

#include "../support/blocks.h"

#include <mortar_contact/laws/paper_law.h>

#include <cmath>

using namespace Test;

namespace
{
  /// The same length everywhere: the penetration is that of the pressure, not
  /// of the cells behind the facets.
  const std::string uniform = "Characteristic length = 0.5";

  template <int dim>
  double
  error(const Blocks &blocks)
  {
    return blocks.stress_error<dim>(*run<dim>(blocks.text<dim>()));
  }

  class MeshRatio : public testing::TestWithParam<unsigned int>
  {};
} // namespace


// X5: one facet against n (2d) or n x n (3d), on either side.
TEST_P(MeshRatio, DoesNotMatter)
{
  const std::string many = std::to_string(GetParam());
  for (const bool lower_is_fine : {true, false})
    {
      Blocks flat, deep;
      (lower_is_fine ? flat.lower : flat.upper) = "Cells = " + many + ",1";
      (lower_is_fine ? flat.upper : flat.lower) = "Cells = 1,1";
      (lower_is_fine ? deep.lower : deep.upper) =
        "Cells = " + many + "," + many + ",1";
      (lower_is_fine ? deep.upper : deep.lower) = "Cells = 1,1,1";
      flat.contact = deep.contact = uniform;
      flat.residual = deep.residual = 1e-11;
      EXPECT_LT(error<2>(flat), 1e-9) << many << lower_is_fine;
      EXPECT_LT(error<3>(deep), 1e-9) << many << lower_is_fine;
    }
}

INSTANTIATE_TEST_SUITE_P(Some, MeshRatio, testing::Values(7u, 20u));
INSTANTIATE_TEST_SUITE_P(All, MeshRatio, testing::Values(50u, 100u));


// X6: facets a thousand and ten thousand times longer than wide, and meshes
// graded by a million.
TEST(ExtremeMeshes, LongFacets)
{
  for (const double width : {1e-2, 1e-3, 1e-4})
    {
      Blocks b;
      b.width   = width;
      b.contact = uniform;
      EXPECT_LT(error<3>(b), width >= 1e-3 ? 1e-8 : 1e-6) << width;
    }
  Blocks graded;
  graded.lower   = "Cells = 24,1|Map = (10^(6*x)-1)/(10^6-1); y";
  graded.upper   = "Cells = 7,1";
  graded.contact = uniform;
  EXPECT_LT(error<2>(graded), 1e-6);
}


// X12: the interface between the blocks is warped, w x y high: between facets
// that are no planes glue passes a uniform stress but for what they gape.
TEST(ExtremeMeshes, WarpedFacets)
{
  for (const double w : {0.05, 0.1, 0.25, 0.5})
    {
      const std::string lift = num(w) + "*(x-0.5)*(y-0.5)";
      for (const bool matching : {true, false})
        {
          Blocks b;
          b.overlap = 0.;
          b.lower   = "Cells = 2,2,1|Map = x; y; z*(1+" + lift + ")";
          b.upper   = std::string("Cells = ") + (matching ? "2,2,1" : "3,3,1") +
                    "|Map = x; y; z+(2-z)*" + lift;
          b.contact  = "Kind = tied|Tie tolerance = 0.5|Characteristic length "
                       "= 0.1|Stiffness = 1e6";
          b.residual = 1e-10;
          const double e = error<3>(b);
          std::cout << w << (matching ? " matching " : " other ") << e << "\n";
          EXPECT_LT(e, matching ? 1e-3 * w : 0.05 * w) << w;
        }
      // contact slips along the warped face: converged, and in balance
      Blocks b;
      b.lower      = "Cells = 2,2,1|Map = x; y; z*(1+" + lift + ")";
      b.upper      = "Cells = 3,3,1|Map = x; y; z+(2-z)*" + lift;
      b.contact    = uniform;
      b.residual   = 1e-9;
      const auto s = run<3>(b.text<3>());
      EXPECT_LT(s->model.interfaces[0]->check_balance(), 1e-12);
      EXPECT_NEAR(s->model.interfaces[0]->report().force[2], -1., 0.05 * w);
    }
}


// X13: vertices on vertices and edges on edges, moved by next to nothing: no
// area is lost or counted twice.
TEST(ExtremeMeshes, CoincidentVertices)
{
  for (const std::string upper : {"2,2,1", "4,4,1", "3,3,1"})
    {
      double depth = 0.;
      for (const double shift : {0., 1e-16, -1e-16, 1e-12, -1e-12, 1e-8, -1e-8})
        {
          Blocks b;
          b.upper             = "Cells = " + upper;
          b.shift             = shift;
          b.contact           = uniform;
          const auto   s      = run<3>(b.text<3>());
          const auto  &report = s->model.interfaces[0]->report();
          const double share  = 1. - std::abs(shift);
          // the upper block rocks by a twelfth of the shift
          EXPECT_NEAR(report.active_area,
                      share * share,
                      1e-12 + 0.2 * std::abs(shift))
            << upper << " " << shift;
          if (shift == 0.)
            depth = report.mean_penetration;
          EXPECT_NEAR(report.mean_penetration,
                      depth,
                      (1e-8 + 10. * std::abs(shift)) * depth)
            << upper << " " << shift;
        }
    }
}


// The error of integration that an interface measures of itself: nothing where
// the rule is exact, something where it is not; also where an obstacle is
// penetrated deeper than the facets are wide.
TEST(ExtremeMeshes, IntegrationErrorIsThatOfTheRule)
{
  const auto of = [](const std::string &contact) {
    Blocks b;
    b.contact  = uniform + "|" + contact;
    b.residual = 1e-9;
    return run<3>(b.text<3>())->model.interfaces[0]->integration_error();
  };
  EXPECT_LT(of("Integration = segments"), 1e-9);
  EXPECT_GT(of("Integration = points|Points per direction = 1"), 1e-3);

  const auto s = run<2>(
    names("block", "all", "i") +
    body("block",
         "Lower corner = 0,0|Upper corner = 1,1|Cells = 50,1",
         "Young's modulus = 1000") +
    rigid("floor", "Type = plane") +
    condition("all", "Body = block|Boundary ids = 0,1,2,3|x = 0|y = -0.1*t") +
    interface("i",
              "Secondary = block: boundary 2|Primary = floor|Characteristic "
              "length = 0.5|Integration = points|Points per direction = 1") +
    solver());
  EXPECT_GT(s->model.interfaces[0]->report().largest_penetration, 0.09);
  EXPECT_LT(s->model.interfaces[0]->integration_error(), 1e-12);
}


namespace
{
  using namespace MortarContact;

  /// A unit square facet that looks up.
  ContactFacet<3>
  square()
  {
    ContactFacet<3> f;
    const double    c[4][2] = {{-.5, -.5}, {.5, -.5}, {.5, .5}, {-.5, .5}};
    for (unsigned int a = 0; a < 4; ++a)
      {
        f.current.x[a]  = Tensor<1, 3>({c[a][0], c[a][1], 0.});
        f.length[a]     = 1.;
        f.compliance[a] = 1e-3;
      }
    f.reference = f.current;
    return f;
  }

  /// Vertices moved by a function; the undeformed facet stays.
  template <class Function>
  ContactFacet<3>
  moved(ContactFacet<3> f, const Function &function)
  {
    for (auto &x : f.current.x)
      x = function(x);
    return f;
  }

  double
  largest(const PairBlock<3> &block)
  {
    double f = 0.;
    for (const double r : block.residual)
      {
        EXPECT_TRUE(std::isfinite(r));
        f = std::max(f, std::abs(r));
      }
    for (const auto &row : block.tangent)
      for (const double k : row)
        EXPECT_TRUE(std::isfinite(k));
    return f;
  }

  PairBlock<3>
  evaluate(const ContactFacet<3> &s, const ContactFacet<3> &p)
  {
    const PaperLaw      law(PressureCurve::parabola_linear, 0.1);
    const PairKernel<3> kernel(law, nullptr, KernelOptions());
    PairBlock<3>        block;
    kernel.evaluate_segments(
      SecondaryFrame<3>(s.current), s, {}, p, nullptr, 1., true, block);
    return block;
  }
} // namespace


// X7: the other facet turns about an axis in the plane, from face to face over
// edge on to back to back, through 89.9, 90 and 90.1 degrees.
TEST(ExtremeMeshes, FacetsAtAnyAngle)
{
  const ContactFacet<3> s = square();
  // turned over so that it faces down, 0.1 deep
  const auto other = [](const double angle) {
    ContactFacet<3> p = square();
    std::swap(p.current.x[1], p.current.x[3]);
    p.reference    = p.current;
    const double c = std::cos(angle), q = std::sin(angle);
    return moved(p, [&](const Tensor<1, 3> &x) {
      return Tensor<1, 3>({c * x[0], x[1], q * x[0] - 0.1});
    });
  };
  const double flat = largest(evaluate(s, other(0.)));
  EXPECT_GT(flat, 0.);
  double       before = flat;
  const double degree = numbers::PI / 180.;
  for (double angle = 0.25; angle <= 180.; angle += 0.25)
    {
      const double f = largest(evaluate(s, other(angle * degree)));
      // forces grow with 1/cos, their weight falls from 60 degrees on
      EXPECT_LT(std::abs(f - before), 0.08 * flat) << angle;
      // the weight of steep pairs is zero from 80 degrees on (THEORY D3)
      if (angle > 80.)
        {
          EXPECT_EQ(f, 0.) << angle;
        }
      before = f;
    }
  for (const double angle : {89.9, 90., 90.1, 180.})
    EXPECT_EQ(largest(evaluate(s, other(angle * degree))), 0.) << angle;
}


// X25: facets that have lost an edge or their area are counted, not computed
// with.
TEST(ExtremeMeshes, FacetsWithoutArea)
{
  const ContactFacet<3> s = square();
  ContactFacet<3>       p = square();
  std::swap(p.current.x[1], p.current.x[3]);
  p.reference        = p.current;
  p                  = moved(p, [](const Tensor<1, 3> &x) {
    return x - Tensor<1, 3>({0., 0., 0.1});
  });
  const double whole = largest(evaluate(s, p));
  // a triangle in a quadrilateral's clothes has half the area
  ContactFacet<3> triangle = s;
  triangle.current.x[3] = triangle.reference.x[3] = s.current.x[2];
  const PairBlock<3> half                         = evaluate(triangle, p);
  EXPECT_NEAR(half.area, 0.5, 1e-12);
  EXPECT_GT(largest(half), 0.);
  // a line, and a point
  for (const double height : {0., 1e-300, 1e-20})
    {
      const auto line = [&](const ContactFacet<3> &f) {
        return moved(f, [&](const Tensor<1, 3> &x) {
          return Tensor<1, 3>({x[0], height * x[1], x[2]});
        });
      };
      const auto point = [&](const ContactFacet<3> &f) {
        return moved(f, [&](const Tensor<1, 3> &x) {
          return Tensor<1, 3>({height * x[0], height * x[1], x[2]});
        });
      };
      for (const auto &[a, b] : {std::make_pair(line(s), p),
                                 std::make_pair(s, line(p)),
                                 std::make_pair(point(s), p),
                                 std::make_pair(s, point(p)),
                                 std::make_pair(line(s), line(p))})
        // forces are per undeformed area: at most those of the whole
        EXPECT_LE(largest(evaluate(a, b)), (1. + 1e-9) * whole) << height;
    }
}
