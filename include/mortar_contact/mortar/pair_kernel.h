// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_mortar_pair_kernel_h
#define mortar_contact_mortar_pair_kernel_h

#include <mortar_contact/geometry/simplex_rule.h>
#include <mortar_contact/geometry/skin.h>
#include <mortar_contact/laws/contact_modulus.h>
#include <mortar_contact/laws/pressure_law.h>
#include <mortar_contact/mortar/segmentation.h>

#include <limits>
#include <optional>
#include <vector>

namespace MortarContact
{
  /// Initial penetration of a secondary facet, see initial_penetration.h.
  template <int dim>
  struct FacetOffset
  {
    VertexValues<dim> level = {}; ///< At the vertices, extrapolated [m].
    double            share = 0.; ///< What is left of it; 0: no offset.
  };

  /// How the contact integral is taken.
  struct Integration
  {
    enum class Rule
    {
      segments, ///< Clipping, exact for plane facets.
      points    ///< Points fixed on the secondary, no clipping: cheaper.
    };
    Rule         rule   = Rule::segments;
    unsigned int degree = 5; ///< Of the rule on segments, 2 to 6.
    /// For Rule::points. Even: no point lies on the middle line of a facet,
    /// where edges of another regular mesh like to be.
    unsigned int points_per_direction = 4;
  };

  /// Which side's stiffness acts.
  enum class StiffnessSide
  {
    secondary, ///< As LS-DYNA: the secondary's only.
    series     ///< Both sides as springs in series.
  };

  /// What one pair contributes. Vectors: see PairVector.
  template <int dim>
  struct PairBlock
  {
    /// Gradient of the contact energy: minus the contact forces [N].
    PairVector<dim> residual = {};
    /// Derivative of the residual, symmetrised on request [N/m]. Rows.
    std::array<PairVector<dim>, max_pair_components<dim>> tangent = {};

    double energy             = 0.; ///< Stored in the contact springs [J].
    double area               = 0.; ///< Overlap, reference area [m^2].
    double active_area        = 0.; ///< Of it where d > 0.
    double penetration_volume = 0.; ///< Integral of d over the active area.
    /// Largest d and d/l with its position, smallest gap; lengths [m].
    double         penetration          = 0.;
    double         relative_penetration = 0.; ///< d / l
    Tensor<1, dim> deepest_position;
    /// Largest overlap of the two meshes: d plus what the treatment of initial
    /// penetrations takes off [m].
    double       overlap       = 0.;
    double       smallest_gap  = std::numeric_limits<double>::max();
    unsigned int n_points      = 0;
    unsigned int n_active      = 0;
    unsigned int n_beyond      = 0;     ///< Points deeper than the ceiling.
    bool         is_degenerate = false; ///< A facet without a usable shape.

    bool
    is_active() const
    {
      return n_active > 0;
    }
  };

  /// What the kernel does, chosen once when an interface is built.
  struct KernelOptions
  {
    Integration   integration;
    StiffnessSide stiffness_side = StiffnessSide::series;
    /// Points with d > ceiling * l are taken for a surface behind, not for
    /// contact. Far beyond the release depth l/2.
    double ceiling = 1.5;
    /// The tangent's symmetric part, or the exact derivative. Exact needs 3 to
    /// 4 iterations where a sharp punch slides, symmetric 7 to 9.
    bool symmetrise = false;
    /// Facets that face each other contribute fully up to the first cosine,
    /// nothing beyond the second: 60 and 80 degrees.
    double full_cosine = 0.5;
    double zero_cosine = 0.17364817766693033;
  };

  /**
   * Contact of facet pairs in the gradient form (THEORY D1):
   *   f_i = sum_q W_q sigma(d_q) dd_q/dx_i,
   * with the penetration d = n_s . (x_s - x_p) of the secondary point x_s, the
   * point x_p where the line along n_s from it meets the primary facet, the
   * exact first variation
   *   delta d = a . (delta x_s - delta x_p - d delta n_s),
   *   a = n_p / (n_p . n_s),
   * and weights W_q of the undeformed secondary. Momentum balances point by
   * point. The tangent is the exact derivative of f, the moving overlap
   * included, in closed form; the tests compare it with automatic
   * differentiation of an independent implementation.
   */
  template <int dim>
  class PairKernel
  {
  public:
    /// @param law must outlive the kernel.
    PairKernel(const PressureLaw &law, const KernelOptions &options);

    /**
     * Evaluate one secondary facet against one primary facet by segments.
     *
     * @param secondary_frame The frame of @p secondary's current facet.
     * @param weight  Factor of the energy: 1/2 for each sweep of a two-sided
     *                interface.
     */
    void
    evaluate_segments(const SecondaryFrame<dim> &secondary_frame,
                      const ContactFacet<dim>   &secondary,
                      const FacetOffset<dim>    &offset,
                      const ContactFacet<dim>   &primary,
                      const double               weight,
                      const bool                 with_tangent,
                      PairBlock<dim>            &block) const;

    /// The fixed points of Rule::points on a facet with @p n_vertices
    /// vertices: reference coordinates and weights.
    std::vector<std::pair<PlanePoint<dim>, double>>
    fixed_points(const unsigned int n_vertices) const;

    /// Modulus and length that act between two points of a pair.
    ContactStiffness
    stiffness(const ContactFacet<dim> &secondary,
              const PlanePoint<dim>   &xi,
              const ContactFacet<dim> &primary,
              const PlanePoint<dim>   &eta) const;

    /// Where the line along the secondary's normal through the fixed point
    /// @p xi meets @p primary, if it does; with the depth there.
    struct Hit
    {
      PlanePoint<dim> eta;
      double          depth;
    };
    std::optional<Hit>
    hit(const SecondaryFrame<dim> &secondary_frame,
        const PlanePoint<dim>     &xi,
        const ContactFacet<dim>   &primary) const;

    /// Add one fixed point of @p secondary, which hits @p primary at @p eta.
    void
    add_fixed_point(const SecondaryFrame<dim> &secondary_frame,
                    const ContactFacet<dim>   &secondary,
                    const FacetOffset<dim>    &offset,
                    const ContactFacet<dim>   &primary,
                    const PlanePoint<dim>     &xi,
                    const PlanePoint<dim>     &eta,
                    const double               weight,
                    const bool                 with_tangent,
                    PairBlock<dim>            &block) const;

    /// Symmetrise the tangent if the options say so; after the last point.
    void
    finish(PairBlock<dim> &block) const;

    const KernelOptions options;

  private:
    struct Point;
    struct Sums;

    /// See stiffness(); from the sides' compliances and lengths.
    ContactStiffness
    combine(const double c_s,
            const double l_s,
            const double c_p,
            const double l_p) const;

    void
    add_point(const SecondaryFrame<dim> &frame,
              const ContactFacet<dim>   &secondary,
              const FacetOffset<dim>    &offset,
              const ContactFacet<dim>   &primary,
              const Point               &point,
              const bool                 with_tangent,
              Sums                      &sums,
              PairBlock<dim>            &block) const;

    void
    add_sums(const SecondaryFrame<dim> &frame,
             const Sums                &sums,
             PairBlock<dim>            &block) const;

    const PressureLaw             *law;
    std::vector<SimplexPoint<dim>> rule;
    std::vector<double>            points_1d, weights_1d;
  };
} // namespace MortarContact

#endif
