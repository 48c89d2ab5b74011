// SPDX-License-Identifier: LGPL-2.1-or-later
#include "pair_forces.h"

#include <mortar_contact/host/contact_interface.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace MortarContact
{
  template <int dim>
  const SurfaceVertex<dim> &
  ContactInterface<dim>::vertex_of(const unsigned int sweep,
                                   const unsigned int s,
                                   const unsigned int p,
                                   const unsigned int a) const
  {
    constexpr unsigned int n = max_vertices<dim>;
    return (a < n) ? surfaces[side_of(sweep, 0)].vertex(s, a) :
                     surfaces[side_of(sweep, 1)].vertex(p, a - n);
  }


  template <int dim>
  bool
  ContactInterface<dim>::has_vertex(const unsigned int sweep,
                                    const unsigned int s,
                                    const unsigned int p,
                                    const unsigned int a) const
  {
    constexpr unsigned int n = max_vertices<dim>;
    if (a < n)
      return a < surfaces[side_of(sweep, 0)].skin.facets[s].current.n_vertices;
    return !obstacle &&
           a - n <
             surfaces[side_of(sweep, 1)].skin.facets[p].current.n_vertices;
  }


  template <int dim>
  std::vector<types::global_dof_index>
  ContactInterface<dim>::dofs_of(const unsigned int sweep,
                                 const unsigned int s,
                                 const unsigned int p) const
  {
    std::vector<types::global_dof_index> result;
    for (unsigned int a = 0; a < 2 * max_vertices<dim>; ++a)
      if (has_vertex(sweep, s, p, a))
        for (const auto &entry : vertex_of(sweep, s, p, a).row)
          result.insert(result.end(), entry.dofs.begin(), entry.dofs.end());
    for (const unsigned int role : {0u, 1u})
      if (const auto *body = body_with_dofs(sweep, role, role == 0 ? s : p))
        result.insert(result.end(), body->dofs().begin(), body->dofs().end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }


  template <int dim>
  void
  ContactInterface<dim>::distribute_pair(
    const unsigned int                            sweep,
    const typename ContactSweep<dim>::ActivePair &pair,
    const bool                                    with_tangent,
    std::vector<types::global_dof_index>         &pair_dofs,
    Vector<double>                               &forces,
    FullMatrix<double>                           &tangent) const
  {
    pair_dofs = dofs_of(sweep, pair.secondary, pair.primary);
    forces.reinit(pair_dofs.size());
    if (with_tangent)
      tangent.reinit(pair_dofs.size(), pair_dofs.size());

    // The rows of the vertex map: component by component.
    struct Term
    {
      unsigned int component; ///< As in PairVector.
      unsigned int dof;       ///< In pair_dofs.
      double       weight;
    };
    std::vector<Term> terms;
    for (unsigned int a = 0; a < 2 * max_vertices<dim>; ++a)
      if (has_vertex(sweep, pair.secondary, pair.primary, a))
        for (const auto &entry :
             vertex_of(sweep, pair.secondary, pair.primary, a).row)
          for (unsigned int i = 0; i < dim; ++i)
            terms.push_back(
              {a * dim + i,
               static_cast<unsigned int>(std::lower_bound(pair_dofs.begin(),
                                                          pair_dofs.end(),
                                                          entry.dofs[i]) -
                                         pair_dofs.begin()),
               entry.weight});

    for (const unsigned int role : {0u, 1u})
      if (const auto *body = body_with_dofs(
            sweep, role, role == 0 ? pair.secondary : pair.primary))
        {
          const auto dof_of = [&](const unsigned int i) {
            return static_cast<unsigned int>(std::lower_bound(pair_dofs.begin(),
                                                              pair_dofs.end(),
                                                              body->dofs()[i]) -
                                             pair_dofs.begin());
          };
          constexpr unsigned int P = max_pair_components<dim>;
          for (unsigned int i = 0; i < dim; ++i)
            terms.push_back({P + i, dof_of(i), 1.});
          const auto T = body->spin_by_dofs();
          for (unsigned int k = 0; k < T.size(); ++k)
            for (unsigned int j = 0; j < T.size(); ++j)
              terms.push_back({P + dim + k, dof_of(dim + j), T[k][j]});
          std::vector<double> residual;
          FullMatrix<double>  K;
          rigid_pair(sweep, pair, role, *body, residual, K);
          for (const Term &row : terms)
            {
              forces(row.dof) -= row.weight * residual[row.component];
              if (with_tangent)
                for (const Term &column : terms)
                  tangent(row.dof, column.dof) +=
                    row.weight * column.weight *
                    K(row.component, column.component);
            }
          if constexpr (dim == 3)
            if (with_tangent)
              {
                // the spin changes with the rotation: T = I + [theta x]/2 + ..
                const double l2 = T[0][0] * T[0][0];
                for (unsigned int i = 0; i < 3; ++i)
                  for (unsigned int j = 0; j < 3; ++j)
                    if (i != j)
                      tangent(dof_of(dim + i), dof_of(dim + j)) +=
                        0.5 * l2 * ((j == (i + 1) % 3) ? -1. : 1.) *
                        residual[P + dim + 3 - i - j];
              }
          return;
        }

    for (const Term &row : terms)
      {
        forces(row.dof) -= row.weight * pair.block.residual[row.component];
        if (with_tangent)
          for (const Term &column : terms)
            tangent(row.dof, column.dof) +=
              row.weight * column.weight *
              pair.block.tangent[row.component][column.component];
      }
  }


  template <int dim>
  const RigidBody<dim> *
  ContactInterface<dim>::body_with_dofs(const unsigned int sweep,
                                        const unsigned int role,
                                        const unsigned int facet) const
  {
    const RigidBody<dim> *body = nullptr;
    if (role == 1 && obstacle)
      body = obstacle.get();
    else
      {
        const ContactSurface<dim> &surface = surfaces[side_of(sweep, role)];
        const SurfaceVertex<dim>  &vertex  = surface.vertex(facet, 0);
        if (vertex.row.empty())
          body = surface.rigid_bodies[vertex.rigid_body].get();
      }
    return (body != nullptr && body->has_dofs()) ? body : nullptr;
  }


  template <int dim>
  void
  ContactInterface<dim>::rigid_pair(
    const unsigned int                            sweep,
    const typename ContactSweep<dim>::ActivePair &pair,
    const unsigned int                            role,
    const RigidBody<dim>                         &body,
    std::vector<double>                          &residual,
    FullMatrix<double>                           &K) const
  {
    // The pair does not notice when both sides move rigidly together. So the
    // forces r on the other side change by a motion (u, w) of the body as by
    // the opposite motion of that side, and turn with w:
    //   dr_a = w x r_a - K_ab (u + w x (x_b - c)),
    // and the body gets -sum r_a and -sum (x_a - c) x r_a.
    constexpr unsigned int P     = max_pair_components<dim>;
    constexpr unsigned int n_w   = RigidBody<dim>::n_rotations;
    const unsigned int     other = 1 - role;
    const unsigned int     first = other * max_facet_components<dim>;
    const auto            &skin  = surfaces[side_of(sweep, other)].skin;
    const Facet<dim>      &facet =
      skin.facets[other == 0 ? pair.secondary : pair.primary].current;
    const unsigned int    n     = facet.n_vertices;
    const Tensor<1, 3>    c     = in_space(body.turning_point());
    const PairBlock<dim> &block = pair.block;

    std::vector<Tensor<1, 3>> r(n), arm(n);
    for (unsigned int a = 0; a < n; ++a)
      {
        arm[a] = in_space(facet.x[a]) - c;
        for (unsigned int i = 0; i < dim; ++i)
          r[a][i] = block.residual[first + a * dim + i];
      }
    std::array<Tensor<1, 3>, n_w> axes;
    for (unsigned int k = 0; k < n_w; ++k)
      axes[k][3 - n_w + k] = 1.;

    residual.assign(P + dim + n_w, 0.);
    K.reinit(P + dim + n_w, P + dim + n_w);
    // rows of the other side
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        {
          const unsigned int row = first + a * dim + i;
          residual[row]          = block.residual[row];
          for (unsigned int b = 0; b < n; ++b)
            for (unsigned int j = 0; j < dim; ++j)
              {
                const double k = block.tangent[row][first + b * dim + j];
                K(row, first + b * dim + j) = k;
                K(row, P + j) -= k;
                for (unsigned int w = 0; w < n_w; ++w)
                  K(row, P + dim + w) -=
                    k * cross_product_3d(axes[w], arm[b])[j];
              }
          for (unsigned int w = 0; w < n_w; ++w)
            K(row, P + dim + w) += cross_product_3d(axes[w], r[a])[i];
        }
    // rows of the body
    const auto add_rows = [&](const unsigned int column) {
      for (unsigned int a = 0; a < n; ++a)
        {
          Tensor<1, 3> dr;
          for (unsigned int i = 0; i < dim; ++i)
            dr[i] = K(first + a * dim + i, column);
          const Tensor<1, 3> moment = cross_product_3d(arm[a], dr);
          for (unsigned int i = 0; i < dim; ++i)
            K(P + i, column) -= dr[i];
          for (unsigned int w = 0; w < n_w; ++w)
            K(P + dim + w, column) -= axes[w] * moment;
        }
    };
    for (unsigned int a = 0; a < n; ++a)
      {
        const Tensor<1, 3> moment = cross_product_3d(arm[a], r[a]);
        for (unsigned int i = 0; i < dim; ++i)
          residual[P + i] -= r[a][i];
        for (unsigned int w = 0; w < n_w; ++w)
          residual[P + dim + w] -= axes[w] * moment;
        for (unsigned int j = 0; j < dim; ++j)
          {
            Tensor<1, 3> e;
            e[j]                      = 1.;
            const Tensor<1, 3> by_arm = cross_product_3d(e, r[a]);
            for (unsigned int w = 0; w < n_w; ++w)
              {
                K(P + dim + w, first + a * dim + j) -= axes[w] * by_arm;
                K(P + dim + w, P + j) += axes[w] * by_arm;
              }
          }
      }
    for (unsigned int b = 0; b < n * dim; ++b)
      add_rows(first + b);
    for (unsigned int j = 0; j < dim + n_w; ++j)
      add_rows(P + j);
  }


  template <int dim>
  double
  ContactInterface<dim>::check_balance() const
  {
    if (obstacle)
      return 0.; // there is no other side to balance
    std::vector<double> sums(8, 0.);
    for_each_pair([&](const unsigned int i, const auto &pair) {
      for_each_force<dim>(surfaces[side_of(i, 0)].skin,
                          obstacle ? nullptr : &surfaces[side_of(i, 1)].skin,
                          pair,
                          [&](const unsigned int,
                              const Tensor<1, 3> &x,
                              const Tensor<1, 3> &force) {
                            const Tensor<1, 3> moment =
                              cross_product_3d(x, force);
                            for (unsigned int c = 0; c < 3; ++c)
                              {
                                sums[c] += force[c];
                                sums[3 + c] += moment[c];
                              }
                            sums[6] += force.norm();
                            sums[7] += x.norm() * force.norm();
                          });
    });
    Utilities::MPI::sum(sums, communicator, sums);
    const auto share =
      [](const double x, const double y, const double z, const double of) {
        return of > 0. ? std::sqrt(x * x + y * y + z * z) / of : 0.;
      };
    return std::max(share(sums[0], sums[1], sums[2], sums[6]),
                    share(sums[3], sums[4], sums[5], sums[7]));
  }


  template <int dim>
  double
  ContactInterface<dim>::check_tangent_at_fetched(const double       time,
                                                  const unsigned int n_samples)
  {
    const std::vector<double> base = values;
    const double share = removal_share(parameters.initial_penetration,
                                       time,
                                       parameters.removal_time);
    double       size  = 0.;
    for (const auto &facet : surfaces[0].skin.facets)
      size = std::max(size, diameter(facet.reference));
    size = Utilities::MPI::max(size, communicator);

    // contact forces of this rank's pairs, and their tangent times a direction
    const auto evaluate_at = [&](const std::vector<double> &at,
                                 const bool                 with_tangent) {
      values = at;
      place_rigid_bodies(time);
      for (auto &surface : surfaces)
        surface.move([&](const auto dof) { return value(dof); });
      evaluate_sweeps(share, time, with_tangent);
    };
    const auto collect = [&](const std::vector<double> *direction) {
      std::vector<double>                  result(dofs.size(), 0.);
      std::vector<types::global_dof_index> pair_dofs;
      Vector<double>                       forces;
      FullMatrix<double>                   tangent;
      for_each_pair([&](const unsigned int i, const auto &pair) {
        distribute_pair(
          i, pair, direction != nullptr, pair_dofs, forces, tangent);
        const auto index = [&](const unsigned int k) {
          return std::lower_bound(dofs.begin(), dofs.end(), pair_dofs[k]) -
                 dofs.begin();
        };
        for (unsigned int r = 0; r < pair_dofs.size(); ++r)
          if (direction == nullptr)
            result[index(r)] -= forces(r);
          else
            for (unsigned int c = 0; c < pair_dofs.size(); ++c)
              result[index(r)] += tangent(r, c) * (*direction)[index(c)];
      });
      return result;
    };

    std::uniform_real_distribution<double> uniform(-1., 1.);
    double                                 worst = 0.;
    for (unsigned int sample = 0; sample < n_samples; ++sample)
      {
        // the same on all ranks that know a dof
        std::vector<double> direction(dofs.size());
        for (std::size_t i = 0; i < dofs.size(); ++i)
          {
            std::mt19937 random(dofs[i] * n_samples + sample);
            direction[i] = uniform(random);
          }
        evaluate_at(base, true);
        const std::vector<double> exact = collect(&direction);
        double                    best  = std::numeric_limits<double>::max();
        for (const double h : {1e-4, 1e-5, 1e-6, 1e-7})
          {
            const auto moved_by = [&](const double by) {
              std::vector<double> at = base;
              for (std::size_t i = 0; i < at.size(); ++i)
                at[i] += by * size * direction[i];
              evaluate_at(at, false);
              return collect(nullptr);
            };
            const std::vector<double> plus = moved_by(h), minus = moved_by(-h);
            double                    error = 0., scale = 0.;
            for (std::size_t i = 0; i < exact.size(); ++i)
              {
                const double difference =
                  (plus[i] - minus[i]) / (2. * h * size);
                error = std::max(error, std::abs(difference - exact[i]));
                scale = std::max(scale, std::abs(exact[i]));
              }
            error = Utilities::MPI::max(error, communicator);
            scale = Utilities::MPI::max(scale, communicator);
            if (scale > 0.)
              best = std::min(best, error / scale);
            else
              best = error;
          }
        worst = std::max(worst, best);
      }
    evaluate_at(base, true);
    return worst;
  }



  template std::vector<types::global_dof_index>
  ContactInterface<2>::dofs_of(const unsigned int,
                               const unsigned int,
                               const unsigned int) const;
  template void
  ContactInterface<2>::distribute_pair(
    const unsigned int,
    const typename ContactSweep<2>::ActivePair &,
    const bool,
    std::vector<types::global_dof_index> &,
    Vector<double> &,
    FullMatrix<double> &) const;
  template double
  ContactInterface<2>::check_balance() const;
  template double
  ContactInterface<2>::check_tangent_at_fetched(const double,
                                                const unsigned int);
  template std::vector<types::global_dof_index>
  ContactInterface<3>::dofs_of(const unsigned int,
                               const unsigned int,
                               const unsigned int) const;
  template void
  ContactInterface<3>::distribute_pair(
    const unsigned int,
    const typename ContactSweep<3>::ActivePair &,
    const bool,
    std::vector<types::global_dof_index> &,
    Vector<double> &,
    FullMatrix<double> &) const;
  template double
  ContactInterface<3>::check_balance() const;
  template double
  ContactInterface<3>::check_tangent_at_fetched(const double,
                                                const unsigned int);
} // namespace MortarContact
