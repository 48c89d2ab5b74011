// SPDX-License-Identifier: LGPL-2.1-or-later

// What another rule of integration would change.

#include <mortar_contact/mortar/contact_sweep.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace MortarContact
{
  template <int dim>
  std::array<double, 2>
  ContactSweep<dim>::compare(const Integration &other,
                             const unsigned int most_facets) const
  {
    std::vector<unsigned int> in_contact;
    for (const ActivePair &pair : active)
      if (in_contact.empty() || in_contact.back() != pair.secondary)
        in_contact.push_back(pair.secondary);
    const std::size_t stride =
      in_contact.size() / std::max(1u, most_facets) + 1;
    std::vector<std::pair<unsigned int, unsigned int>> sample;
    std::size_t                                        chosen = 0, next = 0;
    for (; chosen < in_contact.size(); chosen += stride)
      {
        while (pairs[next].first < in_contact[chosen])
          ++next;
        for (; next < pairs.size() && pairs[next].first == in_contact[chosen];
             ++next)
          sample.push_back(pairs[next]);
      }

    using Forces            = std::array<double, max_facet_components<dim>>;
    const auto facet_forces = [&](const Integration &integration) {
      KernelOptions options = kernel.options;
      options.integration   = integration;
      ContactSweep<dim> sweep(
        secondary, primary, obstacle, law, nullptr, options, weight);
      sweep.history       = history;
      sweep.augmentation  = augmentation;
      sweep.deepest_level = deepest_level;
      sweep.last_reach    = last_reach;
      sweep.pairs         = sample;
      sweep.evaluate(last_share, last_time_step, false);
      std::map<unsigned int, Forces> forces;
      for (const ActivePair &pair : sweep.active)
        {
          Forces &f =
            forces.try_emplace(pair.secondary, Forces{}).first->second;
          for (unsigned int i = 0; i < f.size(); ++i)
            f[i] += pair.block.residual[i];
        }
      return forces;
    };
    const auto size = [](const Forces &a, const Forces &b) {
      double sum = 0.;
      for (unsigned int i = 0; i < a.size(); ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
      return std::sqrt(sum);
    };
    std::map<unsigned int, Forces> ours =
      facet_forces(kernel.options.integration);
    std::array<double, 2> result{{0., 0.}};
    for (const auto &[f, forces] : facet_forces(other))
      {
        const auto mine = ours.try_emplace(f, Forces{}).first;
        result[0] += size(mine->second, forces);
        result[1] +=
          std::max(size(mine->second, Forces{}), size(forces, Forces{}));
        ours.erase(mine);
      }
    for (const auto &[f, forces] : ours)
      for (double &sum : result)
        sum += size(forces, Forces{});
    return result;
  }


  template std::array<double, 2>
  ContactSweep<2>::compare(const Integration &, const unsigned int) const;
  template std::array<double, 2>
  ContactSweep<3>::compare(const Integration &, const unsigned int) const;
} // namespace MortarContact
