// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_mortar_point_kernel_h
#define mortar_contact_mortar_point_kernel_h

#include <mortar_contact/geometry/obstacle.h>
#include <mortar_contact/geometry/skin.h>
#include <mortar_contact/laws/contact_modulus.h>
#include <mortar_contact/laws/friction_law.h>
#include <mortar_contact/laws/pressure_law.h>
#include <mortar_contact/mortar/pair_block.h>

namespace MortarContact
{
  /// How the contact integral is taken.
  struct Integration
  {
    /// Where the points are.
    enum class Rule
    {
      segments, ///< Clipping, exact for plane facets.
      points,   ///< Points fixed on the secondary, no clipping: cheaper.
      nodes     ///< The secondary's vertices: node-to-segment contact.
    };
    Rule         rule   = Rule::segments; ///< Where the points are.
    unsigned int degree = 5;              ///< Of the rule on segments, 2 to 6.
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

  /// What the kernel does, chosen once when an interface is built.
  struct KernelOptions
  {
    Integration integration; ///< How the integral is taken.
    /// Whose stiffness acts.
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
    double zero_cosine = 0.17364817766693033; ///< See full_cosine.

    /// Tangential stiffness over (K/l) while sticking [-].
    double tangential_scale = 0.1;
    /// Slip at which sliding starts [m]; zero: as tangential_scale says.
    double elastic_slip = 0.;
  };

  /// What friction knows of a secondary facet from the last accepted step.
  template <int dim>
  struct FacetSlip
  {
    Facet<dim>                          before; ///< Positions.
    Tensor<1, dim>                      normal; ///< Of that configuration,
    std::array<Tensor<1, dim>, dim - 1> basis;  ///< as in SecondaryFrame.
    /// Elastic slip in the basis, at the vertices [m].
    std::array<PlanePoint<dim>, max_vertices<dim>> elastic;
    double share     = 0.; ///< Of the initial penetration that was left.
    double time_step = 0.; ///< Since then [s]; zero: unknown.
  };

  /// State of a secondary facet during an evaluation.
  template <int dim>
  struct SecondaryState
  {
    /// Initial penetration at the vertices, extrapolated, see
    /// initial_penetration.h [m].
    VertexValues<dim> level = {};
    double            share = 0.; ///< What is left of it [-].
    /// Augmentation at the vertices: depth that the pressure acts as if it were
    /// deeper [m].
    VertexValues<dim> augmentation = {};
    /// Null: no friction.
    const FacetSlip<dim> *slip = nullptr;
  };

  /**
   * The primary's surface about the point x_p where the line along the
   * secondary's normal meets it.
   */
  template <int dim>
  struct PrimaryPoint : SurfacePoint<dim>
  {
    unsigned int n_vertices = 0; ///< That carry forces; none on an obstacle.
    VertexValues<dim>                      N  = {}; ///< Their shape functions,
    std::array<VertexValues<dim>, dim - 1> dN = {}; ///< derivatives by eta.
    double                                 compliance  = 0.; ///< l/K [m/Pa]
    double                                 length      = 0.; ///< l [m]
    std::array<double, dim - 1>            dcompliance = {}; ///< By eta.
    std::array<double, dim - 1>            dlength     = {}; ///< By eta.
    double surface_offset = 0.; ///< Contact surface over mesh [m]
  };

  /// A contact point on the secondary, with the motion of its place and weight.
  template <int dim>
  struct ContactPoint
  {
    PlanePoint<dim> xi;     ///< On the secondary [-]
    double          weight; ///< W, reference area times the sweep's weight.
    bool            moves = false; ///< Whether the next two are there.
    PairVector<dim> dweight; ///< Of W by the positions of the pair's vertices,
    std::array<PairVector<dim>, dim - 1> dxi; ///< and of xi.
  };

  /// What can be summed over the points of a pair before the last product.
  template <int dim>
  struct CurvatureSums
  {
    Tensor<1, dim> across;     ///< sum of W distance (sigma a + tau)
    double         along = 0.; ///< sum of W distance sigma
    /// By component: motion of the force times its distance, and force times
    /// the motion of the distance; what they do is along dn.
    std::array<PairVector<dim>, dim> couple = {};
  };

  /// What happens at one point, without forces.
  template <int dim>
  struct PointState
  {
    double          penetration = 0.; ///< d, with the initial part taken off.
    double          pressure    = 0.; ///< sigma, reference area [Pa]
    double          length      = 0.; ///< l
    PlanePoint<dim> elastic_slip;     ///< After the step [m]
    double          slip   = 0.;      ///< Sliding of the step, length [m]
    bool            sticks = true;    ///< Or slides.
  };

  /**
   * One contact point in the gradient form (THEORY D1): residual, energy and
   * exact tangent. Normal part:
   *   f = W sigma(d) dd/dx,  delta d = a . (delta x_s - delta x_p - d delta n),
   *   a = n_p / (n_p . n_s).
   * Friction (see FrictionLaw) adds the virtual work
   *   W tau . (delta x_s - delta x_p - distance delta n),
   * whose last term, a couple on the secondary facet, balances the moment
   * (THEORY 3.4).
   *
   * Slip: the two points that face each other now were apart by
   * r = x_p - x_s at the end of the last accepted step; the part of r in the
   * secondary's plane of that time is the slip of the step. Rigid motion, also
   * in large steps and at a distance (thick skins), gives none: then r is along
   * the old normal. Only the present pair of facets enters, and r is continuous
   * where a point crosses from one primary facet to the next.
   */
  template <int dim>
  class PointKernel
  {
  public:
    /// @param friction Null: none. Both laws must outlive the kernel.
    PointKernel(const PressureLaw   &law,
                const FrictionLaw   *friction,
                const KernelOptions &options);

    /// Add a point to @p block; what comes of the curvature of n goes to
    /// @p sums and is added once for all by add_curvature().
    void
    add_point(const SecondaryFrame<dim> &frame,
              const ContactFacet<dim>   &secondary,
              const SecondaryState<dim> &state,
              const PrimaryPoint<dim>   &primary,
              const ContactPoint<dim>   &point,
              const bool                 with_tangent,
              CurvatureSums<dim>        &sums,
              PairBlock<dim>            &block) const;

    /// What comes of the curvature of n, once for all points of a pair.
    void
    add_curvature(const SecondaryFrame<dim> &frame,
                  const CurvatureSums<dim>  &sums,
                  PairBlock<dim>            &block) const;

    /// The state at @p xi; depths that are no contact give zero pressure.
    PointState<dim>
    state_at(const SecondaryFrame<dim> &frame,
             const ContactFacet<dim>   &secondary,
             const SecondaryState<dim> &state,
             const PrimaryPoint<dim>   &primary,
             const PlanePoint<dim>     &xi) const;

    /// Modulus and length that act, from the sides' compliances and lengths.
    ContactStiffness
    combine(const double c_s,
            const double l_s,
            const double c_p,
            const double l_p) const;

    /// Whether there is a friction law.
    bool
    has_friction() const
    {
      return friction != nullptr;
    }

    const KernelOptions options; ///< As given.

  private:
    struct Kinematics;
    struct Response;

    /// Slip, return map and traction; THEORY 3.3.
    Response
    friction_response(const SecondaryState<dim> &state,
                      const PrimaryPoint<dim>   &primary,
                      const Kinematics          &k) const;

    void
    add_friction(const SecondaryFrame<dim> &frame,
                 const SecondaryState<dim> &state,
                 const PrimaryPoint<dim>   &primary,
                 const ContactPoint<dim>   &point,
                 const Kinematics          &k,
                 const bool                 with_tangent,
                 CurvatureSums<dim>        &sums,
                 PairBlock<dim>            &block) const;

    /// Place, depth and pressure; no contact: pressure zero.
    Kinematics
    kinematics(const SecondaryFrame<dim> &frame,
               const ContactFacet<dim>   &secondary,
               const SecondaryState<dim> &state,
               const PrimaryPoint<dim>   &primary,
               const PlanePoint<dim>     &xi) const;

    const PressureLaw *law;
    const FrictionLaw *friction;
  };
} // namespace MortarContact

#endif
