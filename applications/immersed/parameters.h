// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_immersed_parameters_h
#define mortar_contact_immersed_parameters_h

#include "leaflets.h"
#include "navier_stokes.h"

#include <mortar_contact/parameters/contact_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Immersed
{
  /// Elastic leaflets in a channel: fluid from the left to the right.
  struct Parameters
  {
    static void
    declare(ParameterHandler &prm);

    /// @throw ExcMessage for what does not fit together.
    void
    read(ParameterHandler &prm);

    // channel
    double       length = 8., height = 1.61; ///< [m]
    unsigned int n_x = 40, n_y = 8;          ///< Cells.
    unsigned int n_refinements = 2;          ///< At the leaflets.
    unsigned int refine_every  = 10;         ///< Steps; 0: at the start only.

    // fluid
    FluidParameters fluid;
    double          penalty      = 0.;   ///< beta [Pa s/m]; 0: automatic.
    bool            has_velocity = true; ///< At the inlet; else a pressure.
    std::string     inflow       = "0";  ///< Of y and t [m/s] or of t [Pa].
    std::string     outlet       = "0";  ///< Pressure, of t [Pa].

    // leaflets
    std::vector<Leaflet> leaflets;
    BeamMaterial         material;
    bool                 has_contact = true;

    MortarContact::ContactParameters contact;

    // run
    double       end_time = 1., first_step = 0.01, smallest_step = 0.; ///< [s]
    double       tolerance    = 1e-7; ///< Of the residual [-].
    unsigned int n_iterations = 15;
    std::string  directory    = "output/immersed_leaflets";
    unsigned int output_every = 10; ///< Steps; 0: the last only.
    unsigned int save_every   = 50; ///< Steps between checkpoints; 0: never.
  };
} // namespace Immersed

#endif
