// SPDX-License-Identifier: LGPL-2.1-or-later

// Bodies that touch themselves: no pair twice, none missed, no wall that sees
// its own far side.

#include "../support/run_scene.h"

#include <mortar_contact/laws/paper_law.h>

#include <set>

using namespace Test;

namespace
{
  /// Pairs with contact that the interface has found, and all that there are:
  /// every ordered pair of facets is tried. @p far tells real pairs from
  /// neighbours in the undeformed body.
  template <int dim, class Far>
  void
  expect_all_pairs_once(const Simulation<dim> &s, const Far &far)
  {
    using namespace MortarContact;
    const auto &contact = *s.model.interfaces[0];
    const auto &skin    = contact.surface(0).skin;

    std::set<std::pair<unsigned int, unsigned int>> found, expected;
    for (const auto &pair : contact.sweep(0).active_pairs())
      EXPECT_TRUE(found.emplace(pair.secondary, pair.primary).second);

    const PaperLaw        law(PressureCurve::parabola_linear, 1.);
    const PairKernel<dim> kernel(law, nullptr, KernelOptions());
    for (unsigned int a = 0; a < skin.facets.size(); ++a)
      {
        const SecondaryFrame<dim> frame(skin.facets[a].current);
        for (unsigned int b = 0; b < skin.facets.size(); ++b)
          {
            if (a == b || !far(centre(skin.facets[a].reference),
                               centre(skin.facets[b].reference)))
              continue;
            PairBlock<dim> block;
            kernel.evaluate_segments(frame,
                                     skin.facets[a],
                                     {},
                                     skin.facets[b],
                                     nullptr,
                                     1.,
                                     false,
                                     block);
            if (block.is_active())
              expected.emplace(a, b);
          }
      }
    EXPECT_GT(expected.size(), 4u);
    EXPECT_EQ(found, expected);
  }
} // namespace


TEST(SingleSurface, StripFoldedOntoItselfFindsEachPairOnce)
{
  // an open ring of wall 0.3 is pressed together until its ends meet
  const auto s = run<2>(
    names("clip", "upper, lower", "itself") +
    body("clip",
         "Type = revolution|Inner radius = 1|Outer radius = 1.3|First angle = "
         "-150|Last angle = 150|Cells = 60,3",
         "Young's modulus = 1000|Poisson's ratio = 0.3") +
    condition("upper", "Body = clip|Boundary ids = 0|x = 0|y = -0.52*t") +
    condition("lower", "Body = clip|Boundary ids = 1|x = 0|y = 0.52*t") +
    interface("itself",
              "Kind = automatic single surface|Secondary = clip|Stiffness "
              "scale = 10") +
    solver(1e-8, 0.1));
  EXPECT_EQ(s->model.interfaces[0]->report().initial.n_facets, 0u);
  EXPECT_EQ(s->model.interfaces[0]->report().initial.n_undetected, 0u);
  // the wall's other side is 0.3 away, what meets is farther
  expect_all_pairs_once(*s, [](const Tensor<1, 2> &x, const Tensor<1, 2> &y) {
    return (x - y).norm() > 0.45;
  });
  EXPECT_LT(s->model.interfaces[0]->check_balance(), 1e-13);
}


TEST(SingleSurface, CoilIsCompressedToSolidHeight)
{
  // three turns of a square wire 0.3 x 0.3, pitch 0.5: gaps of 0.2 close
  const auto s = run<3>(
    names("coil", "base, top", "itself") +
    body("coil",
         "Lower corner = 0,-0.15,-0.15|Upper corner = 18.85,0.15,0.15|Cells = "
         "60,2,2|Map = (1+y)*cos(x); -(1+y)*sin(x); z+0.0795775*x",
         "Young's modulus = 1000|Poisson's ratio = 0.3") +
    condition("base", "Body = coil|Boundary ids = 0|x = 0|y = 0|z = 0") +
    condition("top", "Body = coil|Boundary ids = 1|x = 0|y = 0|z = -0.6*t") +
    interface("itself",
              "Kind = automatic single surface|Secondary = coil|Stiffness "
              "scale = 10") +
    solver(1e-8, 0.1));
  EXPECT_GT(s->model.interfaces[0]->report().active_pairs, 20u);
  // angles along the wire: what meets is a turn apart
  expect_all_pairs_once(*s, [](const Tensor<1, 3> &x, const Tensor<1, 3> &y) {
    const auto turns = [](const Tensor<1, 3> &p) {
      const double angle = std::atan2(-p[1], p[0]) / (2. * numbers::PI);
      return angle + std::round(p[2] / 0.5 - angle);
    };
    return std::abs(turns(x) - turns(y)) > 0.5;
  });
}
