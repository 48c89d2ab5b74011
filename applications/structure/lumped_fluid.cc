// SPDX-License-Identifier: LGPL-2.1-or-later
#include "lumped_fluid.h"

#include <deal.II/base/patterns.h>

#include <cmath>

namespace Structure
{
  void
  FluidParameters::declare(ParameterHandler &prm)
  {
    const Patterns::Double positive(1e-300), not_negative(0.);
    // centimetres, grams, seconds; 1333 dyn/cm^2 are 1 mm Hg
    prm.declare_entry(
      "Ventricle pressure",
      "1.6e4 + 1.5e5*sin(pi*min(max((t - floor(t/0.8)*0.8 - 0.04)/0.32, 0), "
      "1))",
      Patterns::Anything(),
      "A formula of t [pressure]. The default: a beat of 0.8 s, its systole from "
      "0.04 to 0.36 s.");
    prm.declare_entry("Density", "1.06", positive, "[mass/volume]");
    prm.declare_entry(
      "Inlet resistance",
      "5",
      not_negative,
      "From the ventricle to the leaflets [pressure s/volume].");
    prm.declare_entry("Inlet inertance",
                      "0.6",
                      not_negative,
                      "Of the blood there [pressure s^2/volume].");
    prm.declare_entry("Sinus resistance",
                      "5",
                      not_negative,
                      "Of the mouth of a sinus [pressure s/volume].");
    prm.declare_entry("Sinus inertance",
                      "1",
                      not_negative,
                      "Of the blood in a sinus [pressure s^2/volume].");
    prm.declare_entry("Aortic area",
                      "0",
                      not_negative,
                      "Beyond the valve [area]; 0: the tube's.");
    prm.declare_entry("Jet length",
                      "0",
                      not_negative,
                      "Of the blood that the orifice accelerates [length]; 0: "
                      "the root of the aortic area.");
    prm.declare_entry("Leak",
                      "1e-3",
                      Patterns::Double(1e-8, 1.),
                      "Orifice of a closed valve over the tube's area [-].");
    prm.declare_entry("Closed area",
                      "0",
                      not_negative,
                      "Of the polygon of free edges that touch: their "
                      "thickness [area]; 0: three radii times the thickness.");
    prm.declare_entry("Aortic impedance",
                      "60",
                      not_negative,
                      "Z of the Windkessel [pressure s/volume].");
    prm.declare_entry("Peripheral resistance",
                      "1250",
                      positive,
                      "R of the Windkessel [pressure s/volume].");
    prm.declare_entry("Compliance",
                      "1.2e-3",
                      positive,
                      "C of the Windkessel [volume/pressure].");
    prm.declare_entry("Venous pressure", "0", Patterns::Double(), "[pressure]");
    prm.declare_entry("Aortic pressure",
                      "1.07e5",
                      Patterns::Double(),
                      "At the start [pressure].");
  }


  void
  FluidParameters::read(ParameterHandler &prm)
  {
    ventricle             = prm.get("Ventricle pressure");
    density               = prm.get_double("Density");
    inlet_resistance      = prm.get_double("Inlet resistance");
    inlet_inertance       = prm.get_double("Inlet inertance");
    sinus_resistance      = prm.get_double("Sinus resistance");
    sinus_inertance       = prm.get_double("Sinus inertance");
    aortic_area           = prm.get_double("Aortic area");
    jet_length            = prm.get_double("Jet length");
    leak                  = prm.get_double("Leak");
    closed_area           = prm.get_double("Closed area");
    aortic_impedance      = prm.get_double("Aortic impedance");
    peripheral_resistance = prm.get_double("Peripheral resistance");
    compliance            = prm.get_double("Compliance");
    venous_pressure       = prm.get_double("Venous pressure");
    aortic_pressure       = prm.get_double("Aortic pressure");
  }


  LumpedFluid::LumpedFluid(const FluidParameters &parameters,
                           const double           tube_area,
                           const unsigned int     n_sinuses,
                           const double           multiplicity)
    : parameters(parameters)
    , aortic_area(parameters.aortic_area > 0. ? parameters.aortic_area :
                                                tube_area)
    , jet_length(parameters.jet_length > 0. ? parameters.jet_length :
                                              std::sqrt(aortic_area))
    , leak(parameters.leak * tube_area)
    , n_sinuses(n_sinuses)
    , multiplicity(multiplicity)
  {}


  double
  LumpedFluid::orifice(const double polygon, double &derivative) const
  {
    const double x    = polygon - parameters.closed_area;
    const double root = std::sqrt(x * x + leak * leak);
    derivative        = 0.5 * (1. + x / root);
    return leak + 0.5 * (x + root);
  }


  LumpedFluid::State
  LumpedFluid::at_rest(const double ventricle) const
  {
    State state;
    state.lumen      = ventricle;
    state.compliance = parameters.aortic_pressure;
    state.aorta      = parameters.aortic_pressure;
    state.swept.assign(n_sinuses, 0.);
    state.sinuses.assign(n_sinuses, parameters.aortic_pressure);
    return state;
  }


  LumpedFluid::State
  LumpedFluid::step(const State               &before,
                    const double               dt,
                    const double               ventricle,
                    const std::vector<double> &swept,
                    const double               area,
                    Loads                     &loads) const
  {
    const FluidParameters &p     = parameters;
    double                 total = 0.;
    for (const double q : swept)
      total += multiplicity * q;

    // p_L = l_0 - a Q_i,  p_A = w_0 + w Q_i
    const double a   = p.inlet_resistance + p.inlet_inertance / dt;
    const double l_0 = ventricle + p.inlet_inertance / dt * before.inlet;
    const double b   = 1. / (p.compliance / dt + 1. / p.peripheral_resistance);
    const double w_0 = b * (p.compliance / dt * before.compliance +
                            p.venous_pressure / p.peripheral_resistance);
    const double w   = p.aortic_impedance + b;

    // the jet: c_0 - c_1 Q - B Q|Q| = 0
    const double L   = p.density * jet_length / area;
    const double dL  = -L / area;
    const double c_0 = l_0 - w_0 + (a + w) * total + L / dt * before.jet;
    const double c_1 = a + w + L / dt;
    double       B, dB; // losses, and by the area
    if (c_0 > 0.)
      {
        const double x = 1. / area - 1. / aortic_area;
        B              = 0.5 * p.density * x * x;
        dB             = -p.density * x / (area * area);
      }
    else
      {
        B  = 0.5 * p.density / (area * area);
        dB = -2. * B / area;
      }
    State        after;
    const double Q =
      2. * c_0 / (c_1 + std::sqrt(c_1 * c_1 + 4. * B * std::abs(c_0)));
    const double slope = L / dt + 2. * B * std::abs(Q); // of the jet's drop
    const double D     = a + w + slope;

    after.jet   = Q;
    after.inlet = Q - total;
    after.aorta = w_0 + w * after.inlet;
    // by the jet, not by the inlet: a closed one would make it round-off
    after.lumen = after.aorta + L / dt * (Q - before.jet) + B * Q * std::abs(Q);
    after.compliance   = w_0 + b * after.inlet;
    after.swept        = swept;
    const double mouth = p.sinus_resistance + p.sinus_inertance / dt;
    for (unsigned int i = 0; i < n_sinuses; ++i)
      after.sinuses.push_back(after.aorta - mouth * swept[i] +
                              p.sinus_inertance / dt * before.swept[i]);

    loads.values.resize(n_sinuses);
    loads.by_area.assign(n_sinuses,
                         (a + w) *
                           (dL / dt * (before.jet - Q) - dB * Q * std::abs(Q)) /
                           D);
    loads.by_swept.reinit(n_sinuses, n_sinuses);
    for (unsigned int i = 0; i < n_sinuses; ++i)
      {
        loads.values[i] = after.sinuses[i] - after.lumen;
        for (unsigned int j = 0; j < n_sinuses; ++j)
          loads.by_swept(i, j) =
            -(a + w) / D * slope * multiplicity - (i == j ? mouth : 0.);
      }
    return after;
  }
} // namespace Structure
