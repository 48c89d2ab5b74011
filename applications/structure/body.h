// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_body_h
#define mortar_contact_structure_body_h

#include "cell_batches.h"
#include "expression.h"
#include "mid_surfaces.h"

#include <mortar_contact/host/contact_interface.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/types.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Structure
{
  using namespace dealii;

  /// A load on a body, with its formulas.
  template <int dim>
  struct Load
  {
    enum class Type
    {
      body_force, ///< Dead, per undeformed volume.
      traction,   ///< Dead, per undeformed area (shells' edges: length).
      pressure,   ///< Follows the normal, positive pushes.
      moment      ///< About fixed axes, per undeformed length of shells' edges.
    };
    Type                         type;
    std::set<types::boundary_id> boundaries; ///< Not for body forces,
    bool                         on_surface =
      false; ///< or the surface of a shell; pressure on its top.
    std::vector<Expression<dim>> formulas;
    std::array<int, dim>         of_component; ///< -1: none.
  };

  /// A dof of a cell, for fields that are given by formulas.
  template <int dim>
  struct DoFPlace
  {
    Point<dim> x; ///< Undeformed place of its node.
    /// Displacement component; those of shells' directors count from dim.
    unsigned int component;
    /// What turns with the body: x, or the director times its scale.
    Tensor<1, dim> arm;
  };

  /// A node on a part of the boundary.
  template <int dim>
  struct BoundaryNode
  {
    std::array<types::global_dof_index, dim> dofs; ///< Of the model.
    Point<dim>                               x;
    Tensor<1, dim>                           normal; ///< Out of the face.
    /// Of which it was visited, in the order of the whole mesh.
    unsigned int                             cell         = 0;
    bool                                     has_director = false;
    std::array<types::global_dof_index, dim> director_dofs;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &dofs &x &normal &cell &has_director &director_dofs;
    }
  };

  /**
   * What deforms: a solid or a shell with its mesh, elements and material. Each
   * body numbers its dofs itself; numbering gives their numbers in the model.
   * Cells of this rank are counted from 0.
   */
  template <int dim>
  class Body
  {
  public:
    Body(const std::string &name, const MPI_Comm communicator)
      : name(name)
      , communicator(communicator)
    {}

    virtual ~Body() = default;

    const std::string           name;
    const MPI_Comm              communicator;
    MortarContact::DoFNumbering numbering; ///< Set by the model.

    /// Dead load per undeformed volume, expressions of x, y, z, t; empty: none.
    std::string body_force;

    /// Names that the mesh file gives to boundary and material ids, for the
    /// log.
    std::string names_in_file;

    /// Velocity at the start, expressions of x, y, z; empty: at rest.
    std::string initial_velocity;

    virtual types::global_dof_index
    n_dofs() const = 0;

    virtual types::global_dof_index
    n_owned_dofs() const = 0;

    virtual unsigned int
    n_dofs_per_cell(const unsigned int cell) const = 0;

    /// Of all ranks.
    virtual types::global_dof_index
    n_cells() const = 0;

    /// For the log: ", mean dilatation" and the like.
    virtual std::string
    description() const = 0;

    /// Shear modulus times a section of a body of that @p size [N]: what
    /// round-off of stresses is measured by.
    virtual double
    force_scale(const double size) const = 0;

    /// Whether strains are small.
    virtual bool
    is_linear() const = 0;

    /// Whether evaluate() looks at the iterate before.
    virtual bool
    uses_iterates() const
    {
      return false;
    }

    /// Of the whole mesh.
    virtual const std::set<types::boundary_id> &
    boundary_ids() const = 0;

    /// Of the whole mesh.
    virtual const std::set<types::material_id> &
    material_ids() const = 0;

    virtual types::material_id
    material_of(const unsigned int cell) const = 0;

    /// Lower and upper corner of the box around the undeformed body.
    virtual const std::pair<Point<dim>, Point<dim>> &
    box() const = 0;

    /// Hanging nodes and ties within the body, in its own numbering.
    virtual void
    add_constraints(AffineConstraints<double> &constraints) const = 0;

    virtual unsigned int
    n_local_cells() const = 0;

    /// Dofs of a cell in the model's numbering.
    virtual void
    dofs_of(const unsigned int                    cell,
            std::vector<types::global_dof_index> &dofs) const = 0;

    /// The cell in a message.
    virtual std::string
    name_of(const unsigned int cell) const = 0;

    /**
     * Internal forces and tangent of a cell.
     * @param previous Null, or the values one iterate before.
     * @return Nothing is valid if this is false: the cell is inside out.
     */
    virtual bool
    evaluate(const unsigned int    cell,
             const Vector<double> &u,
             const Vector<double> *previous,
             const bool            with_tangent,
             Vector<double>       &forces,
             FullMatrix<double>   &tangent) = 0;

    /// Whether evaluate_step() may be called.
    virtual bool
    keeps_energy() const
    {
      return false;
    }

    /// Internal forces over a step from @p u_n to @p u that do the work by
    /// which the strain energy changes, exactly; and their derivative by u.
    virtual void
    evaluate_step(const unsigned int /*cell*/,
                  const Vector<double> & /*u_n*/,
                  const Vector<double> & /*u*/,
                  const Vector<double> * /*previous*/,
                  const bool /*with_tangent*/,
                  Vector<double> & /*forces*/,
                  FullMatrix<double> & /*tangent*/)
    {
      Assert(false, ExcNotImplemented());
    }

    /// The cells in a form that takes them several at once; null: there is
    /// none for this body. For static runs.
    virtual std::unique_ptr<CellBatches<dim>>
    make_batches(const IndexSet & /*owned*/,
                 const IndexSet & /*relevant*/) const
    {
      return nullptr;
    }

    /// Accept the last evaluation as the end of a step.
    virtual void
    commit()
    {}

    /// All dofs, in the model's numbering, in an order that the mesh alone
    /// gives. Collective.
    virtual std::vector<types::global_dof_index>
    dofs_in_order() const = 0;

    /// What the material of all cells remembers, for checkpoints: the same on
    /// all ranks and on any number of them. Collective.
    virtual std::vector<double>
    history() const
    {
      return {};
    }

    virtual void
    restore(const std::vector<double> &)
    {}

    /// Whether there is an error estimate for such a body.
    virtual bool
    can_be_refined() const
    {
      return false;
    }

    /// Whether each rank knows all cells; if not, level_of(), active_number(),
    /// gradient_jumps() and refine() may not be called.
    virtual bool
    is_whole() const = 0;

    /// How often the mesh was halved to give an active cell, of any rank.
    virtual unsigned int
    level_of(const unsigned int active_cell) const = 0;

    /// Number of the active cell that facets are labelled with.
    virtual unsigned int
    active_number(const types::global_cell_index label) const = 0;

    /// By active cell, of all ranks: mu h/24 times the squared jumps of the
    /// gradient of @p u (in the body's numbering) across its faces [J].
    virtual std::vector<double>
    gradient_jumps(const Vector<double> & /*u*/) const
    {
      Assert(false, ExcNotImplemented());
      return {};
    }

    /**
     * Refine (r) and coarsen (c) active cells. The model must number the dofs
     * anew.
     * @param flags By active cell, the same on all ranks; '.' for none.
     * @param fields Values of all dofs in the body's numbering.
     * @return The same on the new mesh.
     */
    virtual std::vector<Vector<double>>
    refine(const std::string                 &flags,
           const std::vector<Vector<double>> &fields) = 0;

    /// Strain energy of a cell [J].
    virtual double
    energy(const unsigned int cell, const Vector<double> &u) = 0;

    /// Consistent mass matrix of a cell [kg].
    virtual void
    mass(const unsigned int cell, FullMatrix<double> &matrix) = 0;

    /// Add the forces of a load on a cell, and take their derivative from the
    /// tangent (if it is not empty).
    virtual void
    add_load(const unsigned int    cell,
             Load<dim>            &load,
             const Vector<double> &u,
             const double          time,
             Vector<double>       &forces,
             FullMatrix<double>   &tangent) = 0;

    /// Component of a dof of a cell, see DoFPlace.
    virtual unsigned int
    component_of(const unsigned int dof) const = 0;

    virtual DoFPlace<dim>
    place_of(const unsigned int cell, const unsigned int dof) const = 0;

    using Visitor = std::function<void(const BoundaryNode<dim> &)>;

    /// Call @p visit for the nodes of the faces with one of the ids, of this
    /// rank's cells; nodes of several faces come several times.
    virtual void
    visit_boundary_nodes(const std::set<types::boundary_id> &ids,
                         const Visitor                      &visit) const = 0;

    /// Call @p visit for the nodes of this rank's cells, without a normal, in
    /// the order of cells; those of several cells come several times.
    virtual void
    visit_nodes(const Visitor &visit) const = 0;

    /// The nodes of all faces with one of the ids; nodes of several faces come
    /// several times. The same on all ranks. Collective.
    std::vector<BoundaryNode<dim>>
    boundary_nodes(const std::set<types::boundary_id> &ids) const;

    /// The nodes at undeformed places where a formula is not 0, without a
    /// normal. The same on all ranks. Collective.
    std::vector<BoundaryNode<dim>>
    nodes_where(Expression<dim> &formula) const;

    /// The node nearest to a point, without a normal; of several the first in
    /// the order of the whole mesh. Collective.
    BoundaryNode<dim>
    nearest_node(const Point<dim> &x) const;

    /// Add faces to a side of a contact interface.
    virtual void
    add_to(MortarContact::ContactInterface<dim> &interface,
           const bool                            secondary,
           const MortarContact::FaceSelection   &faces) const = 0;

    /// Shells: the triangles of the mid-surface, the same on all ranks; their
    /// parts are material ids. Collective.
    virtual std::vector<MidTriangle>
    mid_surface() const
    {
      return {};
    }

    /// Shells: triangles of the outer surface moved out by @p offset, with
    /// edges, seen counter-clockwise from outside; the same on all ranks.
    /// Collective.
    /// @param u Displacements of all dofs of the model.
    virtual std::vector<std::array<Point<dim>, 3>>
    outer_surface(const Vector<double> & /*u*/, const double /*offset*/) const
    {
      return {};
    }

    /// Values of the dofs of a local cell.
    using ValuesOfCell =
      std::function<const Vector<double> &(const unsigned int)>;

    /// Write displacements and stresses to a VTU file.
    virtual void
    write(const ValuesOfCell &values_of_cell,
          const std::string  &file,
          const MPI_Comm      communicator) = 0;
  };
} // namespace Structure

#endif
