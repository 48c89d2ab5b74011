// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_host_contact_interface_h
#define mortar_contact_host_contact_interface_h

#include <mortar_contact/host/dealii_compat.h>
#include <mortar_contact/host/surface_extractor.h>
#include <mortar_contact/mortar/contact_sweep.h>
#include <mortar_contact/mortar/tie_sweep.h>
#include <mortar_contact/parameters/contact_parameters.h>
#include <mortar_contact/report/contact_report.h>

#include <deal.II/base/index_set.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace MortarContact
{
  /// What an interface thinks of a converged state.
  struct StepAdvice
  {
    /// Whether the step may be committed.
    bool        accept = true;
    std::string reason; ///< Why not, in words.
  };

  /**
   * One contact interface: two surfaces, their law, their history.
   *
   * Life: add_secondary(), add_primary(), setup(); then for each Newton iterate
   * update(), add_couplings() where report().couplings_changed, assemble();
   * then commit() or rollback(). setup() takes what was added since the one
   * before: on a new mesh, or after dofs are numbered anew, add all surfaces
   * and set up again (save() and load() carry the history over). The
   * *secondary* is the side that carries the integration points (LS-DYNA:
   * SURFA, slave); points are projected onto the *primary* (SURFB, master).
   *
   * All functions are collective over the communicator. Nothing is printed.
   * In 2d forces, energies and areas are per unit of thickness.
   * Vectors and matrices may be deal.II's own or those of Trilinos or PETSc;
   * vectors that are read need their locally owned entries only.
   */
  template <int dim>
  class ContactInterface
  {
  public:
    /// @param name In reports, messages and files. @throw ExcMessage where
    /// entries of @p parameters do not fit together.
    ContactInterface(const std::string       &name,
                     const ContactParameters &parameters,
                     const MPI_Comm           communicator);

    /// Sweeps refer to the surfaces: an interface stays where it is.
    ContactInterface(const ContactInterface &) = delete;
    ContactInterface &
    operator=(const ContactInterface &) = delete;

    /**
     * Add boundary faces of a body to the secondary surface. Displacements are
     * the components of the finite element from @p first_component on, dofs are
     * numbered in the matrix as @p numbering says. DoFHandlers are looked at in
     * this call only.
     *
     * @throw ExcMessage if no face on any rank is selected.
     */
    void
    add_secondary(const DoFHandler<dim>    &dof_handler,
                  const Mapping<dim>       &mapping,
                  const FaceSelection      &selection,
                  const ModulusOfCell<dim> &modulus_of_cell,
                  const std::string        &part            = "secondary",
                  const DoFNumbering       &numbering       = {},
                  const unsigned int        first_component = 0);

    /// The same for the primary surface.
    void
    add_primary(const DoFHandler<dim>    &dof_handler,
                const Mapping<dim>       &mapping,
                const FaceSelection      &selection,
                const ModulusOfCell<dim> &modulus_of_cell,
                const std::string        &part            = "primary",
                const DoFNumbering       &numbering       = {},
                const unsigned int        first_component = 0);

    /// Add outer surfaces of a shell, see ShellSkin, its thickness changed as
    /// the parameters say; dofs are numbered in the matrix as @p numbering
    /// says.
    void
    add_secondary(const DoFHandler<dim - 1, dim> &dof_handler,
                  const FaceSelection            &selection,
                  const ShellSkin<dim>           &skin,
                  const std::string              &part      = "secondary",
                  const DoFNumbering             &numbering = {});

    /// The same for the primary side.
    void
    add_primary(const DoFHandler<dim - 1, dim> &dof_handler,
                const FaceSelection            &selection,
                const ShellSkin<dim>           &skin,
                const std::string              &part      = "primary",
                const DoFNumbering             &numbering = {});

    /// Add a rigid body with facets to the secondary surface.
    void
    add_secondary(const std::shared_ptr<RigidBody<dim>> &body);

    /// Add a rigid body to the primary surface. One with a smooth surface must
    /// be all of it.
    void
    add_primary(const std::shared_ptr<RigidBody<dim>> &body);

    /// A friction law of the host's own instead of that of the parameters;
    /// before setup().
    void
    set_friction_law(std::unique_ptr<FrictionLaw> law);

    /**
     * Build the surfaces in the undeformed configuration, find and treat
     * initial penetrations: see report().initial.
     *
     * @throw ExcMessage if penetrations are deeper than MPAR2.
     */
    void
    setup();

    /// All dofs that this interface may write to, of the surfaces on all ranks:
    /// constraints must know of them.
    IndexSet
    relevant_dofs(const types::global_dof_index n_dofs) const;

    /**
     * Evaluate contact at the displacements @p u from the undeformed mesh, in
     * every Newton iteration.
     * @param time At the end of the step [s]: places rigid bodies, gives slip
     *             its rate and removes initial penetrations. The same as of
     *             commit().
     * @param with_tangent Whether assemble() will want the matrix.
     */
    template <class VectorType>
    void
    update(const VectorType &u,
           const double      time         = 0.,
           const bool        with_tangent = true);

    /**
     * Add the entries of all candidate pairs to a sparsity pattern.
     * @param motion Also of the pairs that motions by so many mean diameters of
     *               the facets would bring [-]: for more entries, new patterns
     *               are rarer.
     */
    template <class SparsityType>
    void
    add_couplings(SparsityType                    &sparsity,
                  const AffineConstraints<double> &constraints,
                  const double                     motion = 0.);

    /// Of the dofs @p owned by this rank those that pairs with forces of any
    /// rank act on: what ContactPreconditioner solves exactly. Collective.
    IndexSet
    active_dofs(const IndexSet &owned) const;

    /// matrix += tangent, rhs += contact forces (minus the residual). Neither
    /// is compressed. @throw ExcMessage if couplings are missing.
    template <class MatrixType, class VectorType>
    void
    assemble(MatrixType                      &matrix,
             VectorType                      &rhs,
             const AffineConstraints<double> &constraints) const;

    /// rhs += contact forces.
    template <class VectorType>
    void
    assemble(VectorType                      &rhs,
             const AffineConstraints<double> &constraints) const;

    /// Largest factor in (0, 1] for the Newton update @p du at @p u by which
    /// no facet passes another unseen.
    template <class VectorType>
    double
    largest_safe_step(const VectorType &u, const VectorType &du);

    /**
     * Largest share of a step by which no facet passes another unseen: the
     * rigid bodies that are moved go from where they were at the last commit()
     * to their place at @p time, the others from @p u by @p du. A driver may
     * ask before it solves the step; else advice() says so afterwards.
     */
    template <class VectorType>
    double
    largest_safe_step(const VectorType &u,
                      const VectorType &du,
                      const double      time);

    /**
     * One augmentation of the last update(), taken as converged.
     * @return True if penetrations were above the tolerance: solve the step
     * again. Always false without augmentation.
     */
    bool
    augment();

    /// Whether the last update(), taken as converged, may be committed.
    StepAdvice
    advice() const;

    /// Accept the last update() as the state at the end of a step, at its time.
    /// @throw ExcMessage where advice() refuses it because displacements are
    /// no numbers, or facets beyond the release depth (Release::cut_back).
    void
    commit(const double time);

    /// Forget the last update(): nothing of it has touched the history, and
    /// report() is that of the last commit() again.
    void
    rollback();

    /// Of the last update(), of setup(), or, after rollback(), of commit().
    const ContactReport &
    report() const
    {
      return last_report;
    }

    /// Write the complete state at the last commit(), the same on all ranks. It
    /// knows neither of the mesh nor of ranks.
    void
    save(std::ostream &out) const;

    /**
     * Continue from what save() wrote, after setup(), with the displacements
     * @p u at that commit(). The surfaces and parameters must be the same; mesh
     * and number of ranks need not: history follows the undeformed places of
     * the material points. All ranks must get the same text.
     *
     * @throw ExcMessage if the state belongs to another interface.
     */
    template <class VectorType>
    void
    load(std::istream &in, const VectorType &u);

    /**
     * Largest difference between the tangent and central differences of the
     * contact forces at @p u, over the largest tangent entry, in @p n_samples
     * directions. For tests and for users of laws of their own; exact tangents
     * give about 1e-8, symmetric ones do not. The forces have kinks where edges
     * of the two surfaces lie on each other, and between stick and slip, as
     * after the commit() of a sliding state: there it is large.
     */
    template <class VectorType>
    double
    check_tangent(const VectorType  &u,
                  const double       time      = 0.,
                  const unsigned int n_samples = 3);

    /// Sum of all contact forces and of their moments about the origin, on both
    /// bodies: zero to round-off, over the sum of their magnitudes. Zero by
    /// definition with an obstacle, which has no vertices.
    double
    check_balance() const;

    /**
     * What a better rule of integration would change of the contact forces on
     * facets at the last update(), over the larger of both: an estimate of the
     * error of the rule that is used, 1 where only one of them sees contact;
     * from at most @p most_facets facets in contact of each rank. Ties are not
     * looked at. Collective.
     */
    double
    integration_error(const unsigned int most_facets = 500) const;

    /// As given; in reports, messages and files.
    const std::string name;
    /// As given.
    const ContactParameters parameters;

    /// The surfaces, for output: 0 secondary, 1 primary.
    const ContactSurface<dim> &
    surface(const unsigned int side) const
    {
      AssertIndexRange(side, 2);
      return surfaces[side];
    }

    /// Whether the primary is one smooth rigid surface: points, no segments.
    bool
    is_on_obstacle() const
    {
      return obstacle != nullptr;
    }

    /// Sweeps: one, or two with swapped sides.
    const ContactSweep<dim> &
    sweep(const unsigned int i) const
    {
      AssertIndexRange(i, sweeps.size());
      return *sweeps[i];
    }

    /// 1, or 2 where both sides take both parts in turn.
    unsigned int
    n_sweeps() const
    {
      return sweeps.size();
    }

    /// Ties; null for kinds without.
    const TieSweep<dim> *
    ties() const
    {
      return tie_sweep.get();
    }

    /// Surface of a sweep's secondary (@p role 0) and primary (1).
    unsigned int
    side_of(const unsigned int sweep, const unsigned int role) const
    {
      if (parameters.kind == ContactParameters::Kind::automatic_single_surface)
        return 0;
      return (role == 0) ? sweep : 1 - sweep;
    }

    /// Call function(sweep, pair) for all pairs with forces of this rank; ties
    /// count to sweep 0.
    template <class Function>
    void
    for_each_pair(const Function &function) const
    {
      for (unsigned int i = 0; i < sweeps.size(); ++i)
        for (const auto &pair : sweeps[i]->active_pairs())
          function(i, pair);
      if (tie_sweep)
        for (const auto &pair : tie_sweep->active_pairs())
          function(0u, pair);
    }

  private:
    void
    add(const unsigned int        side,
        const DoFHandler<dim>    &dof_handler,
        const Mapping<dim>       &mapping,
        const FaceSelection      &selection,
        const ModulusOfCell<dim> &modulus_of_cell,
        const std::string        &part,
        const DoFNumbering       &numbering,
        const unsigned int        first_component);

    void
    add_shell(const unsigned int              side,
              const DoFHandler<dim - 1, dim> &dof_handler,
              const FaceSelection            &selection,
              ShellSkin<dim>                  skin,
              const std::string              &part,
              const DoFNumbering             &numbering);

    void
    add_facets(const unsigned int                    side,
               const std::vector<SurfaceFacet<dim>> &facets,
               const std::string                    &part);

    void
    add_rigid(const unsigned int                     side,
              const std::shared_ptr<RigidBody<dim>> &body);

    /// Forget the surfaces of an earlier setup().
    void
    begin_adding();

    void
    build_surface(const unsigned int side);

    /// The rigid facets of the primary must point to the secondary: forming
    /// contact turns or refuses those that do not, automatic contact counts
    /// them.
    void
    check_tool_normals();

    /// Facets that ties hold have no contact.
    void
    exclude_tied_facets();

    /// Penetration at which a converged state is not accepted, share of l.
    double
    deepest_share() const;

    /**
     * Active pairs of a sweep that are deeper than the release depth without
     * having lost their contact in this step: their facets have moved by less
     * than what they are deeper. They have come beside each other, like a
     * shell's top and its neighbour's bottom when the edges between them have
     * pushed into each other, and were never in front of each other. By pair;
     * empty: there are none.
     */
    std::vector<char>
    pairs_behind(const ContactSweep<dim> &sweep, const unsigned int i) const;

    /// Evaluate all sweeps where the surfaces are.
    /// @param share What is left of the initial penetrations.
    void
    evaluate_sweeps(const double share,
                    const double time,
                    const bool   with_tangent);

    void
    detect_initial_penetrations();

    /// Move the rigid bodies to their place at a time, or to where the fetched
    /// values of their dofs say.
    void
    place_rigid_bodies(const double time);

    /// Whether the rigid bodies that are moved may go to their place at @p time
    /// in one step, see largest_safe_step(); from the last accepted state to
    /// the values fetched.
    void
    check_motion_of_tools(const double time);

    /// Largest safe share of a motion between two sets of values of dofs, each
    /// with a time for the rigid bodies. Leaves everything at the first.
    double
    safe_step_between(std::vector<double> &from,
                      const double         from_time,
                      std::vector<double> &to,
                      const double         to_time);

    void
    number_parts();

    /// Number of the part that a facet belongs to.
    unsigned int
    part_of_facet(const unsigned int side, const unsigned int facet) const
    {
      return number_of_part[side][surfaces[side].skin.parts[facet]];
    }

    /// The rigid body with dofs behind a facet, if there is one.
    const RigidBody<dim> *
    body_with_dofs(const unsigned int sweep,
                   const unsigned int role,
                   const unsigned int facet) const;

    /// Forces and tangent of a pair of which the side @p role is a rigid body
    /// with dofs: on the components of the other side, and, behind
    /// max_pair_components, on the body's translations and spins.
    void
    rigid_pair(const unsigned int                            sweep,
               const typename ContactSweep<dim>::ActivePair &pair,
               const unsigned int                            role,
               const RigidBody<dim>                         &body,
               std::vector<double>                          &residual,
               FullMatrix<double>                           &tangent) const;

    /// Place of one dof among those fetched.
    std::size_t
    place_of(const types::global_dof_index dof) const;

    /// Value of one dof as fetched by fetch().
    double
    value(const types::global_dof_index dof) const;

    /// All dofs of the facets that this rank knows, and of rigid bodies.
    std::vector<types::global_dof_index>
    known_dofs() const;

    /// Get the values of these dofs from their owners.
    template <class VectorType>
    void
    fetch(const VectorType &u);

    /// Know who has which of these dofs, and who wants which of @p owned.
    void
    prepare_fetch(const IndexSet &owned);

    /// Send the values that other ranks have asked for, and receive theirs.
    /// @param answers By rank, in the order of asked_of_me.
    void
    exchange(const std::map<unsigned int, std::vector<double>> &answers);

    /// Boxes around the facets of this rank.
    std::vector<Box<dim>>
    own_boxes(const unsigned int side) const;

    /**
     * Get to know all primary facets of other ranks that lie in @p regions, by
     * sweep (ties: as sweep 0). Each rank tells the others at most a few boxes;
     * facets go from their rank to those that look there, once.
     * @param regions     Called only where there are other ranks.
     * @param boxes       The same, of this rank's facets, by side; empty: where
     *                    they are.
     * @param more_states Values by dof that must go with the facets, besides
     *                    those that are members.
     * @return Whether this rank knows more than before.
     */
    bool
    bring_near(
      const std::function<std::vector<std::vector<Box<dim>>>()>   &regions,
      const std::function<std::array<std::vector<Box<dim>>, 2>()> &boxes = {},
      const std::vector<std::vector<double> *> &more_states              = {});

    /// The same for all that a search, and couplings, may find.
    void
    bring_candidates_near();

    void
    load_at_fetched(std::istream &in);

    void
    evaluate(const double time, const bool with_tangent);

    double
    check_tangent_at_fetched(const double time, const unsigned int n_samples);

    void
    make_report();

    /// Dofs and weights of one vertex of a pair.
    const SurfaceVertex<dim> &
    vertex_of(const unsigned int sweep,
              const unsigned int s,
              const unsigned int p,
              const unsigned int a) const;

    /// Whether vertex @p a of a pair, counted as in PairVector, exists.
    bool
    has_vertex(const unsigned int sweep,
               const unsigned int s,
               const unsigned int p,
               const unsigned int a) const;

    /// Dofs of a pair, without repetition.
    std::vector<types::global_dof_index>
    dofs_of(const unsigned int sweep,
            const unsigned int s,
            const unsigned int p) const;

    /// Forces and tangent of an active pair on its dofs.
    void
    distribute_pair(const unsigned int                            sweep,
                    const typename ContactSweep<dim>::ActivePair &pair,
                    const bool                                    with_tangent,
                    std::vector<types::global_dof_index>         &dofs,
                    Vector<double>                               &forces,
                    FullMatrix<double> &tangent) const;

    const MPI_Comm                                  communicator;
    std::unique_ptr<PressureLaw>                    law;
    std::unique_ptr<FrictionLaw>                    friction;
    std::vector<SurfaceFacet<dim>>                  extracted[2];
    ContactSurface<dim>                             surfaces[2];
    std::shared_ptr<RigidBody<dim>>                 obstacle; ///< Primary.
    std::vector<std::shared_ptr<RigidBody<dim>>>    rigid_bodies;
    std::vector<std::unique_ptr<ContactSweep<dim>>> sweeps;
    std::unique_ptr<TieSweep<dim>>                  tie_sweep;
    ContactReport                                   last_report;
    ContactReport accepted_report; ///< Of the last commit(), or of setup().
    /// Pairs that the matrix has entries for, by sweep.
    std::vector<std::vector<std::pair<unsigned int, unsigned int>>> coupled;
    bool   pattern_is_current = false;
    bool   has_tangent        = false; ///< Of the last update().
    bool   is_finite          = true;  ///< So are all values fetched.
    bool   is_augmented       = true; ///< Penetrations are below the tolerance.
    double largest_tool_step  = 1.;   ///< See check_motion_of_tools().
    std::vector<std::string>  part_names;
    std::vector<unsigned int> number_of_part[2]; ///< By part of the surface.
    unsigned int              part_of_obstacle = 0;
    bool         is_set_up        = false; ///< The next add_..() starts anew.
    double       last_time        = 0.;    ///< Of the last update() [s]
    double       committed_time   = 0.;    ///< Of the last commit() [s]
    double       dissipation      = 0.;    ///< By friction until then [J]
    unsigned int n_rigid_vertices = 0;

    std::vector<types::global_dof_index> dofs; ///< See known_dofs().
    types::global_dof_index end_of_dofs = 0;   ///< Behind those of all ranks.
    std::vector<double>     values;            ///< Of these dofs,
    std::vector<double>     committed_values;  ///< last accepted,
    /// and at the last commit(), whatever has been fetched for that time since.
    std::vector<double> accepted_values;
    bool                has_committed_values = false; ///< Or only zeros.
    bool                has_accepted_values  = false; ///< Or only zeros.

    /// Facets of this rank that others know, by side and rank.
    std::map<unsigned int, std::set<unsigned int>> told[2];
    double coupled_motion = 0.; ///< Largest ever asked of add_couplings().

    // What fetch() does: as last prepared,
    IndexSet                             fetched_owned;
    std::vector<types::global_dof_index> fetched;
    /// what ranks want of this one,
    std::map<unsigned int, std::vector<types::global_dof_index>> asked_of_me;
    /// where what ranks send goes to.
    std::map<unsigned int, std::vector<std::size_t>> places;
  };
} // namespace MortarContact

#include <mortar_contact/host/contact_interface.templates.h>

#endif
