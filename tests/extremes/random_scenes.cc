// SPDX-License-Identifier: LGPL-2.1-or-later

// Scenes drawn at random from all that an interface can be told. Whatever
// comes: refused in words, solved, or given up with the last state saved; never
// a number that is none, forces in balance, and the same in other units.

#include "../support/run_scene.h"

#include <cmath>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>

using namespace Test;

namespace
{
  /// Draws from one seed.
  class Dice
  {
  public:
    explicit Dice(const unsigned int seed)
      : random(seed)
    {}

    double
    between(const double a, const double b)
    {
      return std::uniform_real_distribution<double>(a, b)(random);
    }

    unsigned int
    number(const unsigned int a, const unsigned int b)
    {
      return std::uniform_int_distribution<unsigned int>(a, b)(random);
    }

    /// From 10^a to 10^b.
    double
    power(const double a, const double b)
    {
      return std::pow(10., between(a, b));
    }

    std::string
    of(const std::vector<std::string> &choices)
    {
      return choices[number(0, choices.size() - 1)];
    }

    bool
    sometimes(const double share)
    {
      return between(0., 1.) < share;
    }

  private:
    std::mt19937 random;
  };

  /// A block pressed into another and slid over it.
  template <int dim>
  std::string
  scene(const unsigned int seed, const double length, const double modulus)
  {
    Dice              dice(seed);
    const std::string down = dim == 3 ? "4" : "2", up = dim == 3 ? "5" : "3";
    const auto        corner = [&](const double x, const double y) {
      return num(length * x) + "," +
             (dim == 3 ? num(length * x) + "," : std::string()) +
             num(length * y);
    };
    const auto cells = [&]() {
      const unsigned int most = dim == 3 ? 4 : 12;
      std::string        text =
        "|Cells = " + std::to_string(dice.number(1, most)) + ",";
      if (dim == 3)
        text += std::to_string(dice.number(1, most)) + ",";
      return text + std::to_string(dice.number(1, 3)) +
             (dice.sometimes(0.25) ? "|Simplices = true" : "");
    };
    const auto material = [&](const double E) {
      return "Law = " + dice.of({"linear elastic", "neo-Hookean"}) +
             "|Young's modulus = " + num(modulus * E) +
             "|Poisson's ratio = " + num(dice.between(0., 0.49));
    };
    const auto degree = [&]() {
      return std::string(dice.sometimes(0.25) ? "Degree = 2" : "");
    };

    const double overlap = dice.sometimes(0.3) ? 0. : dice.between(-0.02, 0.04);
    const double low     = dice.between(-0.3, 0.3);
    const double high    = low + dice.between(0.3, 1.2);
    std::string  text    = names("lower, upper", "base, top", "i") +
                       body("lower",
                            "Lower corner = " + corner(0., 0.) +
                              "|Upper corner = " + corner(1., 1.) + cells(),
                            material(1000.),
                            degree());
    text += body("upper",
                 "Lower corner = " + corner(low, 1. - overlap) +
                   "|Upper corner = " + corner(high, 1.6) + cells(),
                 material(1000. * dice.power(-2., 3.)),
                 degree());
    const std::string z = dim == 3 ? "z" : "y";
    const std::string slide =
      num(length * dice.between(-0.2, 0.2)) + "*max(0, 2*t-1)";
    const std::string press =
      "-" + num(length * dice.power(-4., -1.)) + "*min(1, 2*t)";
    text += condition("base",
                      "Body = lower|Boundary ids = " + down + "|x = 0|y = 0" +
                        (dim == 3 ? "|z = 0" : ""));
    text += condition("top",
                      "Body = upper|Boundary ids = " + up + "|x = " + slide +
                        (dim == 3 ? "|y = 0|z = " : "|y = ") + press);

    const std::string kind      = dice.of({"forming surface to surface",
                                           "automatic surface to surface",
                                           "automatic surface to surface",
                                           "automatic single surface",
                                           "tied",
                                           "tiebreak"});
    const bool        is_single = kind == "automatic single surface";
    const bool        has_ties  = kind == "tied" || kind == "tiebreak";
    std::string       contact =
      "Kind = " + kind + "|Secondary = lower: boundary " + up +
      (is_single ? "; upper: boundary " : "|Primary = upper: boundary ") + down;
    const auto maybe = [&](const double share, const std::string &entry) {
      if (dice.sometimes(share))
        contact += "|" + entry;
    };
    maybe(0.5, "Integration = " + dice.of({"segments", "points", "nodes"}));
    maybe(0.3, "Degree = " + std::to_string(dice.number(2, 6)));
    maybe(0.5, "Law = " + dice.of({"linear", "parabola linear"}));
    maybe(0.7, "Stiffness scale = " + num(dice.power(-1., 4.)));
    maybe(0.3, "Progressive stiffening = " + num(dice.power(0., 2.)));
    maybe(0.3, "Stiffness side = " + dice.of({"secondary", "series"}));
    maybe(0.3, "Release = " + dice.of({"report", "cut back", "never"}));
    maybe(0.2, "Tangent = symmetric");
    maybe(0.2, "Characteristic length = " + num(length * dice.power(-2., 0.)));
    maybe(0.4, "Friction coefficient = " + dice.of({"0", "1e-6", "0.3", "10"}));
    if (kind == "tiebreak")
      contact += "|Tiebreak = strength|Normal strength = " +
                 num(modulus * dice.power(-2., 3.)) +
                 "|Shear strength = " + num(modulus * dice.power(-2., 3.));
    if (has_ties)
      contact += "|Tie tolerance = " + num(length * 0.1);
    else
      maybe(0.5,
            "Initial penetration = " +
              dice.of({"track",
                       "ignore",
                       "remove over time|Removal time = 0.5",
                       "remove over time deep|Removal time = 0.5|Deepest "
                       "initial penetration = " +
                         num(length * 0.05)}));
    maybe(0.15,
          "Augmentation = Uzawa|Penetration tolerance = " + num(length * 1e-5));
    return text + interface("i", contact) + solver(1e-9, 0.25) +
           section("Steps", "Smallest step = 0.05|Times to meet = 0.5");
  }

  /// What became of a scene.
  struct Outcome
  {
    std::string               refusal; ///< Empty: it was run.
    ExitCode                  code = finished;
    double                    time = 0.;
    Tensor<1, 3>              force; ///< Without units.
    std::vector<Tensor<1, 3>> reactions;
    double                    balance = 0., largest = 0.;
    bool                      has_saved = false; ///< A state to go on from.
  };

  template <int dim>
  Outcome
  play(const unsigned int seed, const double length, const double modulus)
  {
    Outcome o;
    Log     log(MPI_COMM_WORLD, true);
    try
      {
        const auto s      = make<dim>(scene<dim>(seed, length, modulus), log);
        o.code            = s->run();
        o.time            = s->time;
        const double unit = modulus * std::pow(length, dim - 1);
        // a single surface has no side of its own: the part counts
        for (const auto &part : s->model.interfaces[0]->report().parts)
          if (part.name == "lower")
            o.force = part.force / unit;
        for (const unsigned int c : {0u, 1u})
          {
            const Tensor<1, 3> reaction = s->model.reaction(c) / unit;
            o.reactions.push_back(reaction);
          }
        o.balance = s->model.interfaces[0]->check_balance();
        o.largest = s->u.linfty_norm() / length;
        o.has_saved =
          !!std::ifstream(s->scene.output.directory + "/checkpoint/state");
      }
    catch (const ExcMessage &e)
      {
        std::ostringstream info;
        e.print_info(info);
        o.refusal = info.str();
      }
    return o;
  }

  unsigned int n_scenes = 0, n_solved = 0;

  template <int dim>
  void
  check(const unsigned int seed)
  {
    ++n_scenes;
    const Outcome o = play<dim>(seed, 1., 1.);
    if (!o.refusal.empty())
      {
        // in words, with the entry
        EXPECT_NE(o.refusal.find('\''), std::string::npos) << o.refusal;
        std::cout << "refused: " << o.refusal << std::endl;
        return;
      }
    std::cout << (o.code == finished ? "solved" : "given up") << " at "
              << o.time << ", force " << o.force << std::endl;
    EXPECT_TRUE(o.code == finished || o.code == no_convergence);
    n_solved += o.code == finished;
    EXPECT_TRUE(o.code == finished || o.has_saved);
    EXPECT_TRUE(std::isfinite(o.largest));
    EXPECT_LT(o.largest, 2.);
    EXPECT_LT(o.balance, 1e-11);
    // what contact pushes the lower block with, its base gives back; overlaps
    // at time 0 are there without
    const double scale =
      std::max({o.force.norm(), o.reactions[0].norm(), 1e-4});
    if (o.time > 0.)
      {
        EXPECT_LT((o.force + o.reactions[0]).norm(), 1e-6 * scale);
        EXPECT_LT((o.reactions[0] + o.reactions[1]).norm(), 1e-6 * scale);
      }

    if (o.code == finished)
      {
        const Outcome other = play<dim>(seed, 1e-3, 1e6);
        EXPECT_EQ(other.code, finished);
        EXPECT_LT((other.force - o.force).norm(), 1e-6 * scale);
      }
  }

  class RandomScenes : public testing::TestWithParam<unsigned int>
  {
  protected:
    static void
    TearDownTestSuite()
    {
      // scenes that are all refused or given up show nothing
      std::cout << n_solved << " of " << n_scenes << " solved" << std::endl;
      EXPECT_GE(2 * n_solved, n_scenes);
    }
  };
} // namespace


TEST_P(RandomScenes, AreSolvedOrRefused)
{
  if (GetParam() % 3 == 0)
    check<3>(GetParam());
  else
    check<2>(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Some, RandomScenes, testing::Range(0u, 60u));
INSTANTIATE_TEST_SUITE_P(All, RandomScenes, testing::Range(1000u, 2000u));
