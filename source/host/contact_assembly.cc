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
  double
  ContactInterface<dim>::check_balance() const
  {
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

    // contact forces, and tangent times a direction
    const auto evaluate_at = [&](const std::vector<double> &at,
                                 const bool                 with_tangent) {
      values = at;
      for (auto &surface : surfaces)
        surface.move([&](const auto dof) { return value(dof); });
      for (const auto &sweep : sweeps)
        sweep->evaluate(share, time - committed_time, with_tangent);
      if (tie_sweep)
        tie_sweep->evaluate(with_tangent);
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
      Utilities::MPI::sum(result, communicator, result);
      return result;
    };

    std::mt19937                           random(1);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    double                                 worst = 0.;
    for (unsigned int sample = 0; sample < n_samples; ++sample)
      {
        std::vector<double> direction(dofs.size());
        for (double &d : direction)
          d = uniform(random);
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
