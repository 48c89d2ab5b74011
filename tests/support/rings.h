// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_tests_rings_h
#define mortar_contact_tests_rings_h

// Two rings in each other, a quarter of them (BENCHMARKS A4, A5).

#include "run_scene.h"

#include <array>
#include <cmath>

namespace Test
{
  /// Mean and cos 2 theta amplitude of the contact pressure on the secondary.
  template <int dim>
  std::array<double, 2>
  fourier(const Simulation<dim> &s)
  {
    double p0 = 0., p2 = 0., total = 0.;
    for (const auto &f :
         MortarContact::facet_states(*s.model.interfaces[0], MPI_COMM_WORLD))
      if (f.side == 0)
        {
          const double a = MortarContact::area(f.current);
          for (unsigned int v = 0; v < f.current.n_vertices; ++v)
            {
              const double theta =
                std::atan2(f.reference.x[v][1], f.reference.x[v][0]);
              const double share = a / f.current.n_vertices;
              total += share;
              p0 += share * f.pressure[v];
              p2 += share * f.pressure[v] * 2. * std::cos(2. * theta);
            }
        }
    return {{p0 / total, p2 / total}};
  }

  /// Two quarter rings, symmetric, with the names inner and outer.
  inline std::string
  rings(const std::string &inner,
        const std::string &inner_material,
        const std::string &outer,
        const std::string &outer_material,
        const std::string &conditions,
        const std::string &more = "")
  {
    return names("inner, outer",
                 "symmetry i, symmetry o" + conditions,
                 "fit",
                 "in, out") +
           body("inner",
                "Type = revolution|Last angle = 90|" + inner,
                inner_material,
                more) +
           body("outer",
                "Type = revolution|Last angle = 90|" + outer,
                outer_material,
                more) +
           condition("symmetry i",
                     "Body = inner|Boundary ids = 0, 1|Type = symmetry") +
           condition("symmetry o",
                     "Body = outer|Boundary ids = 0, 1|Type = symmetry") +
           interface(
             "fit",
             "Secondary = inner: boundary 3|Primary = outer: boundary 2|Law = linear");
  }

  /// The load of A4, a twentieth of it, in any unit of pressure.
  inline std::string
  cosine_load(const double modulus = 1.)
  {
    return condition("load",
                     "Body = outer|Boundary ids = 3|Type = pressure|"
                     "Pressure = " +
                       num(modulus) + "*(5e5 + 5e4*cos(2*atan2(y, x)))");
  }

  inline std::string
  linear_steel(const std::string &E, const std::string &nu)
  {
    return "Law = linear elastic|Young's modulus = " + E +
           "|Poisson's ratio = " + nu;
  }
} // namespace Test

#endif
