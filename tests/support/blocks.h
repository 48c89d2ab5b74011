// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_tests_blocks_h
#define mortar_contact_tests_blocks_h

// Two unit blocks on each other under uniform pressure, in any units, at any
// place, of any stiffness: the contact patch test (BENCHMARKS A1).

#include "run_scene.h"

namespace Test
{
  /// What differs between scenes of two blocks.
  struct Blocks
  {
    double length  = 1.;         ///< Edge of the blocks.
    double modulus = 1.;         ///< Pressure; Young's modulus of the upper
                                 ///< block is a thousand times that.
    double      ratio    = 1.;   ///< Young's modulus, lower over upper.
    double      origin   = 0.;   ///< Added to all coordinates.
    double      overlap  = 1e-3; ///< At the start, share of the length.
    double      shift    = 0.;   ///< Of the upper block along x and y.
    double      width    = 1.;   ///< Along y (3d), share of the length.
    std::string lower    = "Cells = 2,2,1";
    std::string upper    = "Cells = 3,3,1";
    std::string contact  = "";
    double      residual = 1e-12; ///< Newton's force tolerance.
    double      nu       = 0.3;   ///< Poisson's ratio of both.

    /// A block between two corners in shares of the length.
    template <int dim>
    std::string
    box(const std::array<double, 3> &low,
        const std::array<double, 3> &high) const
    {
      std::string text;
      for (const auto &[name, corner] :
           {std::make_pair("Lower", &low), std::make_pair("|Upper", &high)})
        {
          text += std::string(name) + " corner = ";
          for (unsigned int i = 0; i < dim; ++i)
            text += (i > 0 ? "," : "") + num(origin + length * (*corner)[i]);
        }
      return text + "|";
    }

    template <int dim>
    std::string
    text() const
    {
      const auto elastic = [&](const double E) {
        return "Law = linear elastic|Young's modulus = " + num(modulus * E) +
               "|Poisson's ratio = " + num(nu);
      };
      constexpr bool    is_3d = dim == 3;
      const double      w     = is_3d ? width : 1.;
      const std::string up    = is_3d ? "5" : "3";
      const std::string down  = is_3d ? "4" : "2";
      // the free contraction of the upper block holds it sideways
      const double      strain = (is_3d ? nu : nu * (1. + nu)) / 1000.;
      const std::string o = num(origin + length * shift), e = num(strain);
      using Corner        = std::array<double, 3>;
      const double bottom = 1. - overlap;
      const Corner low{{0., 0., 0.}}, high{{1., is_3d ? w : 1., 1.}};
      const Corner upper_low =
        is_3d ? Corner{{shift, shift, bottom}} : Corner{{shift, bottom, 0.}};
      const Corner upper_high = is_3d ? Corner{{1. + shift, w + shift, 2.}} :
                                        Corner{{1. + shift, 2., 0.}};
      return names("lower, upper",
                   std::string("base, side x, sides, load") +
                     (is_3d ? ", side y" : ""),
                   "i") +
             body("lower",
                  box<dim>(low, high) + lower,
                  elastic(1000. * std::max(1., ratio))) +
             body("upper",
                  box<dim>(upper_low, upper_high) + upper,
                  elastic(1000. * std::max(1., 1. / ratio))) +
             condition("base",
                       "Body = lower|Type = symmetry|Boundary ids = " + down) +
             condition("side x",
                       "Body = lower|Type = symmetry|Boundary ids = 0") +
             (is_3d ?
                condition("side y",
                          "Body = lower|Type = symmetry|Boundary ids = 2") :
                "") +
             condition("sides",
                       "Body = upper|Boundary ids = " + up + "|x = " + e +
                         "*(x-" + o + ")" +
                         (is_3d ? "|y = " + e + "*(y-" + o + ")" : "")) +
             condition("load",
                       "Body = upper|Type = pressure|Boundary ids = " + up +
                         "|Pressure = " + num(modulus)) +
             interface("i",
                       "Secondary = lower: boundary " + up +
                         "|Primary = upper: boundary " + down +
                         (contact.empty() ? "" : "|" + contact)) +
             solver(residual);
    }

    /// Largest deviation of any stress component of any cell from the exact
    /// one, over the pressure.
    template <int dim>
    double
    stress_error(const Simulation<dim> &s) const
    {
      double error = 0.;
      for (const auto &b : s.model.bodies)
        for_each_cell(s, b->name, [&](const auto &, const CellState &state) {
          for (unsigned int i = 0; i < 3; ++i)
            for (unsigned int j = 0; j < 3; ++j)
              {
                const bool   is_vertical = i == dim - 1 && j == dim - 1;
                const double exact       = is_vertical ? -1. :
                                           (dim == 2 && i == 2 && j == 2) ? -nu :
                                                                            0.;
                const double found       = state.stress[i][j] / modulus;
                // not a number is no small error
                error = (std::abs(found - exact) <= error) ?
                          error :
                          std::abs(found - exact);
              }
        });
      return error;
    }
  };
} // namespace Test

#endif
