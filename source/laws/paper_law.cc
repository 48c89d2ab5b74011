// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/laws/paper_law.h>

#include <algorithm>
#include <cmath>

namespace MortarContact
{
  namespace
  {
    /// f0 with its integral and its derivative, x >= 0.
    NormalResponse
    base_curve(const PressureCurve curve, const double x)
    {
      switch (curve)
        {
          case PressureCurve::parabola:
            return {x * x * x / 12., x * x / 4., x / 2.};
          case PressureCurve::linear:
            return {x * x / 2., x, 1.};
          case PressureCurve::parabola_linear:
            if (x < 2.)
              return {x * x * x / 12., x * x / 4., x / 2.};
            return {x * x / 2. - x + 2. / 3., x - 1., 1.};
          default:
            if (x < 2.)
              return {x * x * x * x * (1. / 16. - x / 80.),
                      x * x * x * (1. / 4. - x / 16.),
                      x * x * (3. / 4. - x / 4.)};
            return {x * x / 2. - x + 3. / 5., x - 1., 1.};
        }
    }
  } // namespace


  PaperLaw::PaperLaw(const PressureCurve curve,
                     const double        scale,
                     const double        stiffening,
                     const double        largest,
                     const double        width,
                     const bool          barrier)
    : curve(curve)
    , scale(scale)
    , width(width)
    , barrier(barrier)
    , x_q(largest / (2. * width))
    , x_m(largest / width)
    , x_end(barrier ? x_q + barrier_end * (x_m - x_q) : x_m)
    , cubic((barrier ? std::max(stiffening - 1., 1.) : stiffening - 1.) *
            base_curve(curve, x_m).pressure)
    , at_end(curve_at(x_end))
  {}


  NormalResponse
  PaperLaw::curve_at(const double x) const
  {
    NormalResponse f = base_curve(curve, x);
    if (x > x_q && cubic > 0.)
      {
        const double range = x_m - x_q;
        const double s     = (x - x_q) / range;
        if (barrier)
          {
            const double t = 1. - s;
            f.energy -= cubic * range *
                        (s * s * s / 3. + s * s / 2. + s + std::log1p(-s));
            f.pressure += cubic * s * s * s / t;
            f.stiffness += cubic * s * s * (3. - 2. * s) / (t * t) / range;
          }
        else
          {
            f.energy += cubic * range * s * s * s * s / 4.;
            f.pressure += cubic * s * s * s;
            f.stiffness += cubic * 3. * s * s / range;
          }
      }
    return f;
  }


  NormalResponse
  PaperLaw::normalised(const double depth) const
  {
    const double   x = depth / width;
    NormalResponse f;
    if (x <= x_end)
      f = curve_at(x);
    else
      {
        const double beyond = x - x_end;
        f.energy            = at_end.energy + at_end.pressure * beyond +
                   at_end.stiffness * beyond * beyond / 2.;
        f.pressure  = at_end.pressure + at_end.stiffness * beyond;
        f.stiffness = at_end.stiffness;
      }
    // dd/dx = eps l turns the integral over x into one over d / l
    return {scale * width * width * f.energy,
            scale * width * f.pressure,
            scale * f.stiffness};
  }


  double
  PaperLaw::inverse(const double pressure) const
  {
    if (!(pressure > 0.))
      return 0.;
    // Bracket, then Newton safeguarded by bisection: f grows without bound.
    double low = 0., high = width;
    while (normalised(high).pressure < pressure)
      {
        low = high;
        high *= 2.;
      }
    double depth = 0.5 * (low + high);
    for (unsigned int i = 0; i < 200; ++i)
      {
        const NormalResponse r               = normalised(depth);
        (r.pressure < pressure ? low : high) = depth;
        double next = depth - (r.pressure - pressure) / r.stiffness;
        if (!(next > low && next < high))
          next = 0.5 * (low + high);
        const double change = std::abs(next - depth);
        depth               = next;
        if (change <= 1e-16 * depth)
          break;
      }
    return depth;
  }
} // namespace MortarContact
