// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_parameters_contact_parameters_h
#define mortar_contact_parameters_contact_parameters_h

#include <mortar_contact/laws/initial_penetration.h>
#include <mortar_contact/mortar/pair_kernel.h>
#include <mortar_contact/parameters/friction_parameters.h>
#include <mortar_contact/parameters/tie_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace MortarContact
{
  /**
   * All settings of one interface, with LS-DYNA's defaults. Lengths, pressures
   * and times are in the units of the mesh, the materials and the loads.
   *
   * Usage: declare() on a ParameterHandler that stands in the interface's
   * subsection, parse the file, read(); read() checks what patterns cannot.
   * Hosts without a ParameterHandler set the members and call check().
   */
  struct ContactParameters
  {
    /// Kinds of contact, with LS-DYNA's names.
    enum class Kind
    {
      forming_surface_to_surface,   ///< One sweep over the secondary.
      automatic_surface_to_surface, ///< One over each side at half weight.
      automatic_single_surface,     ///< The secondary against itself.
      tied,                         ///< For good.
      tiebreak                      ///< Until a law fails, then contact.
    };

    /// What happens when a converged state penetrates too deep.
    enum class Release
    {
      report,   ///< As LS-DYNA: contact is dropped, and said so.
      cut_back, ///< The step is rejected.
      never     ///< The law grows without bound: a barrier.
    };

    /// Tools of forming contact must point to the blank.
    enum class ToolNormals
    {
      check, ///< An error if they do not.
      turn   ///< Facets that point away are turned.
    };

    /// Uzawa's method on the pointwise pressure.
    struct Augmentation
    {
      bool         is_on     = false; ///< Uzawa's iteration.
      double       tolerance = 0.;    ///< Penetration that may stay [m].
      unsigned int most      = 20;    ///< Augmentations per step.
    };

    /// Kind of contact.
    Kind kind = Kind::automatic_surface_to_surface;
    /// How the integral is taken.
    Integration integration;
    /// Name of the pressure law, see PressureLaw.
    std::string law             = "parabola linear";
    double      stiffness_scale = 1.;  ///< SFS [-]
    double      penalty_factor  = 0.1; ///< SLSFAC [-]
    double      modulus         = 0.;  ///< K [Pa]; 0: of the cells' materials.
    /// "secondary", "series" or "automatic", see side().
    std::string stiffness_side = "automatic";
    /// "local", "shortest edge", or a length [m].
    std::string characteristic_length  = "local";
    double      progressive_stiffening = 1.; ///< IGAP [-], >= 1
    double      largest_penetration    = 0.; ///< PENMAX [m]; 0: l/2.
    /// What happens beyond the largest penetration.
    Release release          = Release::cut_back;
    double  secondary_offset = 0.; ///< [m]
    double  primary_offset   = 0.; ///< [m]
    double  thickness        = 0.; ///< Of shells, SST [m]; 0: their own.
    double  thickness_scale  = 1.; ///< SFST

    /// IGNORE
    InitialPenetration initial_penetration = InitialPenetration::stress;
    double             initial_pressure    = 0.; ///< MPAR1 for ignore [Pa]
    double             removal_time        = 0.; ///< MPAR1 for remove [s]
    double             deepest_penetration = 0.; ///< MPAR2 [m]

    /// Off without a coefficient.
    FrictionParameters friction;
    /// For kinds with ties.
    TieParameters tie;
    /// Off.
    Augmentation augmentation;
    /// Of forming contact.
    ToolNormals tool_normals = ToolNormals::check;

    unsigned int report_every = 1; ///< MINFO, steps; 0: never.
    /// In each report.
    unsigned int n_worst_facets = 3;
    /// Its symmetric part only.
    bool symmetric_tangent = false;

    /// Declare all entries with their defaults and help.
    static void
    declare(ParameterHandler &prm);

    /// Read what declare() declared, and check it.
    void
    read(ParameterHandler &prm);

    /// Throw an exception that says which entries do not fit together.
    void
    check() const;

    /// The one that acts: where automatic, as the kind says.
    StiffnessSide
    side() const;

    /// Sweeps of a kind: two for automatic surface to surface and tiebreak.
    unsigned int
    n_sweeps() const;

    /// Tied, or tied until a law fails.
    bool
    has_ties() const
    {
      return kind == Kind::tied || kind == Kind::tiebreak;
    }

    /// The explicit characteristic length [m]; zero if it comes from the mesh.
    double
    explicit_length() const;

    /// Largest penetration as a share of the characteristic length: 1/2, but
    /// for a PENMAX beside an explicit length.
    double
    largest_share() const;
  };

  /// Name of a treatment of initial penetrations as in parameter files.
  std::string
  to_string(const InitialPenetration treatment);
} // namespace MortarContact

#endif
