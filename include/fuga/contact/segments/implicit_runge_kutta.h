// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_segments_implicit_runge_kutta_h
#define fuga_contact_segments_implicit_runge_kutta_h

#include <array>
#include <cstddef>

namespace fuga
{
  /**
   * A singly diagonally implicit Runge-Kutta pair of order 5(4) with explicit first stage:
   * ESDIRK5(4)7L[2]SA2 of C. A. Kennedy and M. H. Carpenter, Diagonally implicit Runge-Kutta
   * methods for stiff ODEs, Appl. Numer. Math. 146 (2019) 221-244. It is L-stable, its stages have
   * order 2, and its last stage is the result, so that the result exactly satisfies whatever the
   * stages satisfy exactly.
   */
  namespace runge_kutta
  {
    constexpr std::size_t n_stages = 7;
    /** The diagonal of all implicit stages. */
    constexpr double diagonal = 23. / 125.;

    /** Abscissae of the stages on the unit interval. */
    constexpr std::array<double, n_stages> abscissae = {{0.,
                                                         46. / 125.,
                                                         7121331996143. / 11335814405378.,
                                                         49. / 353.,
                                                         3706679970760. / 5295570149437.,
                                                         347. / 382.,
                                                         1.}};

    /** Weights of the rates of earlier stages (row: stage); the last row also gives the result. */
    constexpr std::array<std::array<double, n_stages>, n_stages> weights = {
      {{{0.}},
       {{23. / 125., diagonal}},
       {{791020047304. / 3561426431547., 791020047304. / 3561426431547., diagonal}},
       {{-158159076358. / 11257294102345.,
         -158159076358. / 11257294102345.,
         -85517644447. / 5003708988389.,
         diagonal}},
       {{-1653327111580. / 4048416487981.,
         -1653327111580. / 4048416487981.,
         1514767744496. / 9099671765375.,
         14283835447591. / 12247432691556.,
         diagonal}},
       {{-4540011970825. / 8418487046959.,
         -4540011970825. / 8418487046959.,
         -1790937573418. / 7393406387169.,
         10819093665085. / 7266595846747.,
         4109463131231. / 7386972500302.,
         diagonal}},
       {{-188593204321. / 4778616380481.,
         -188593204321. / 4778616380481.,
         2809310203510. / 10304234040467.,
         1021729336898. / 2364210264653.,
         870612361811. / 2470410392208.,
         -1307970675534. / 8059683598661.,
         diagonal}}}};

    /** The result of the embedded method of order 4. */
    constexpr std::array<double, n_stages> embedded = {{-582099335757. / 7214068459310.,
                                                        -582099335757. / 7214068459310.,
                                                        615023338567. / 3362626566945.,
                                                        3192122436311. / 6174152374399.,
                                                        6156034052041. / 14430468657929.,
                                                        -1011318518279. / 9693750372484.,
                                                        1914490192573. / 13754262428401.}};
  } // namespace runge_kutta
} // namespace fuga

#endif
