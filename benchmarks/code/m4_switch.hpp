// Machine M4 of the code benchmark as hand-written code: a switch on the state, with a nested switch on the event.
// Transitions of a composite state are tried after those of its children.
#pragma once

#include <cstdint>

#include "actuator.hpp"

namespace by_hand_m4 {

enum class At : std::uint8_t {
    S0, S1, S2, S3, S4, S5, S6, S7, S8, S9,
    S10, S11, S12, S13, S14, S15, S16, S17, S18, S19,
    S20, S21, S22, S23, S24, S25, S26, S27, S28, S29,
    S30, S31, S32, S33, S34, S35, S36, S37, S38, S39,
    S40, S41, S42, S43, S44, S45, S46, S47, S48, S49,
    S50, S51, S52, S53, S54, S55, S56, S57, S58, S59,
    S60, S61, S62, S63, S64, S65, S66, S67, S68, S69,
    S70, S71, S72, S73, S74, S75, S76, S77, S78, S79,
    S80, S81, S82, S83, S84, S85, S86, S87, S88, S89,
    S90, S91, S92, S93, S94, S95, S96, S97, S98, S99,
};

struct State {
    At at = At::S0;
};

inline void begin(State&) {
}

inline bool step(State& s, unsigned e) {
    switch (s.at) {
        case At::S0:
            switch (e) {
                case 3: act(300); s.at = At::S13; return true;
                case 2: act(301); s.at = At::S92; return true;
                default: break;
            }
            return false;
        case At::S1:
            switch (e) {
                case 6: act(302); s.at = At::S19; return true;
                case 3: act(303); s.at = At::S11; return true;
                default: break;
            }
            return false;
        case At::S2:
            switch (e) {
                case 1: act(304); s.at = At::S51; return true;
                case 0: act(305); s.at = At::S70; return true;
                default: break;
            }
            return false;
        case At::S3:
            switch (e) {
                case 4: act(306); s.at = At::S97; return true;
                case 6: act(307); s.at = At::S7; return true;
                default: break;
            }
            return false;
        case At::S4:
            switch (e) {
                case 3: act(308); s.at = At::S68; return true;
                case 4: act(309); s.at = At::S46; return true;
                default: break;
            }
            return false;
        case At::S5:
            switch (e) {
                case 4: act(310); s.at = At::S22; return true;
                case 6: act(311); s.at = At::S13; return true;
                default: break;
            }
            return false;
        case At::S6:
            switch (e) {
                case 4: act(312); s.at = At::S3; return true;
                case 1: act(313); s.at = At::S82; return true;
                default: break;
            }
            return false;
        case At::S7:
            switch (e) {
                case 4: act(314); s.at = At::S34; return true;
                case 6: act(315); s.at = At::S24; return true;
                default: break;
            }
            return false;
        case At::S8:
            switch (e) {
                case 2: act(316); s.at = At::S37; return true;
                case 7: act(317); s.at = At::S80; return true;
                default: break;
            }
            return false;
        case At::S9:
            switch (e) {
                case 5: act(318); s.at = At::S77; return true;
                case 0: act(319); s.at = At::S43; return true;
                default: break;
            }
            return false;
        case At::S10:
            switch (e) {
                case 6: act(320); s.at = At::S31; return true;
                case 4: act(321); s.at = At::S22; return true;
                default: break;
            }
            return false;
        case At::S11:
            switch (e) {
                case 3: act(322); s.at = At::S35; return true;
                case 7: act(323); s.at = At::S11; return true;
                default: break;
            }
            return false;
        case At::S12:
            switch (e) {
                case 4: act(324); s.at = At::S37; return true;
                case 0: act(325); s.at = At::S73; return true;
                default: break;
            }
            return false;
        case At::S13:
            switch (e) {
                case 4: act(326); s.at = At::S97; return true;
                case 6: act(327); s.at = At::S65; return true;
                default: break;
            }
            return false;
        case At::S14:
            switch (e) {
                case 3: act(328); s.at = At::S54; return true;
                case 7: act(329); s.at = At::S76; return true;
                default: break;
            }
            return false;
        case At::S15:
            switch (e) {
                case 4: act(330); s.at = At::S57; return true;
                case 3: act(331); s.at = At::S20; return true;
                default: break;
            }
            return false;
        case At::S16:
            switch (e) {
                case 3: act(332); s.at = At::S33; return true;
                case 2: act(333); s.at = At::S5; return true;
                default: break;
            }
            return false;
        case At::S17:
            switch (e) {
                case 1: act(334); s.at = At::S59; return true;
                case 0: act(335); s.at = At::S80; return true;
                default: break;
            }
            return false;
        case At::S18:
            switch (e) {
                case 4: act(336); s.at = At::S68; return true;
                case 7: act(337); s.at = At::S82; return true;
                default: break;
            }
            return false;
        case At::S19:
            switch (e) {
                case 7: act(338); s.at = At::S43; return true;
                case 5: act(339); s.at = At::S18; return true;
                default: break;
            }
            return false;
        case At::S20:
            switch (e) {
                case 3: act(340); s.at = At::S52; return true;
                case 0: act(341); s.at = At::S25; return true;
                default: break;
            }
            return false;
        case At::S21:
            switch (e) {
                case 7: act(342); s.at = At::S23; return true;
                case 2: act(343); s.at = At::S45; return true;
                default: break;
            }
            return false;
        case At::S22:
            switch (e) {
                case 6: act(344); s.at = At::S75; return true;
                case 5: act(345); s.at = At::S41; return true;
                default: break;
            }
            return false;
        case At::S23:
            switch (e) {
                case 3: act(346); s.at = At::S12; return true;
                case 2: act(347); s.at = At::S7; return true;
                default: break;
            }
            return false;
        case At::S24:
            switch (e) {
                case 3: act(348); s.at = At::S97; return true;
                case 2: act(349); s.at = At::S74; return true;
                default: break;
            }
            return false;
        case At::S25:
            switch (e) {
                case 3: act(350); s.at = At::S42; return true;
                case 0: act(351); s.at = At::S22; return true;
                default: break;
            }
            return false;
        case At::S26:
            switch (e) {
                case 4: act(352); s.at = At::S3; return true;
                case 3: act(353); s.at = At::S5; return true;
                default: break;
            }
            return false;
        case At::S27:
            switch (e) {
                case 5: act(354); s.at = At::S10; return true;
                case 7: act(355); s.at = At::S36; return true;
                default: break;
            }
            return false;
        case At::S28:
            switch (e) {
                case 5: act(356); s.at = At::S41; return true;
                case 0: act(357); s.at = At::S36; return true;
                default: break;
            }
            return false;
        case At::S29:
            switch (e) {
                case 5: act(358); s.at = At::S99; return true;
                case 1: act(359); s.at = At::S83; return true;
                default: break;
            }
            return false;
        case At::S30:
            switch (e) {
                case 6: act(360); s.at = At::S79; return true;
                case 7: act(361); s.at = At::S87; return true;
                default: break;
            }
            return false;
        case At::S31:
            switch (e) {
                case 1: act(362); s.at = At::S79; return true;
                case 2: act(363); s.at = At::S24; return true;
                default: break;
            }
            return false;
        case At::S32:
            switch (e) {
                case 7: act(364); s.at = At::S17; return true;
                case 2: act(365); s.at = At::S32; return true;
                default: break;
            }
            return false;
        case At::S33:
            switch (e) {
                case 6: act(366); s.at = At::S20; return true;
                case 4: act(367); s.at = At::S42; return true;
                default: break;
            }
            return false;
        case At::S34:
            switch (e) {
                case 0: act(368); s.at = At::S5; return true;
                case 2: act(369); s.at = At::S58; return true;
                default: break;
            }
            return false;
        case At::S35:
            switch (e) {
                case 2: act(370); s.at = At::S46; return true;
                case 7: act(371); s.at = At::S37; return true;
                default: break;
            }
            return false;
        case At::S36:
            switch (e) {
                case 1: act(372); s.at = At::S26; return true;
                case 3: act(373); s.at = At::S54; return true;
                default: break;
            }
            return false;
        case At::S37:
            switch (e) {
                case 3: act(374); s.at = At::S7; return true;
                case 0: act(375); s.at = At::S7; return true;
                default: break;
            }
            return false;
        case At::S38:
            switch (e) {
                case 0: act(376); s.at = At::S21; return true;
                case 5: act(377); s.at = At::S76; return true;
                default: break;
            }
            return false;
        case At::S39:
            switch (e) {
                case 2: act(378); s.at = At::S5; return true;
                case 4: act(379); s.at = At::S69; return true;
                default: break;
            }
            return false;
        case At::S40:
            switch (e) {
                case 7: act(380); s.at = At::S31; return true;
                case 4: act(381); s.at = At::S41; return true;
                default: break;
            }
            return false;
        case At::S41:
            switch (e) {
                case 0: act(382); s.at = At::S67; return true;
                case 7: act(383); s.at = At::S37; return true;
                default: break;
            }
            return false;
        case At::S42:
            switch (e) {
                case 6: act(384); s.at = At::S25; return true;
                case 5: act(385); s.at = At::S61; return true;
                default: break;
            }
            return false;
        case At::S43:
            switch (e) {
                case 3: act(386); s.at = At::S56; return true;
                case 1: act(387); s.at = At::S52; return true;
                default: break;
            }
            return false;
        case At::S44:
            switch (e) {
                case 7: act(388); s.at = At::S28; return true;
                case 0: act(389); s.at = At::S53; return true;
                default: break;
            }
            return false;
        case At::S45:
            switch (e) {
                case 7: act(390); s.at = At::S82; return true;
                case 1: act(391); s.at = At::S54; return true;
                default: break;
            }
            return false;
        case At::S46:
            switch (e) {
                case 3: act(392); s.at = At::S24; return true;
                case 7: act(393); s.at = At::S4; return true;
                default: break;
            }
            return false;
        case At::S47:
            switch (e) {
                case 0: act(394); s.at = At::S32; return true;
                case 2: act(395); s.at = At::S31; return true;
                default: break;
            }
            return false;
        case At::S48:
            switch (e) {
                case 3: act(396); s.at = At::S29; return true;
                case 6: act(397); s.at = At::S53; return true;
                default: break;
            }
            return false;
        case At::S49:
            switch (e) {
                case 4: act(398); s.at = At::S41; return true;
                case 1: act(399); s.at = At::S6; return true;
                default: break;
            }
            return false;
        case At::S50:
            switch (e) {
                case 5: act(400); s.at = At::S14; return true;
                case 4: act(401); s.at = At::S72; return true;
                default: break;
            }
            return false;
        case At::S51:
            switch (e) {
                case 6: act(402); s.at = At::S83; return true;
                case 5: act(403); s.at = At::S91; return true;
                default: break;
            }
            return false;
        case At::S52:
            switch (e) {
                case 0: act(404); s.at = At::S49; return true;
                case 3: act(405); s.at = At::S11; return true;
                default: break;
            }
            return false;
        case At::S53:
            switch (e) {
                case 6: act(406); s.at = At::S73; return true;
                case 1: act(407); s.at = At::S21; return true;
                default: break;
            }
            return false;
        case At::S54:
            switch (e) {
                case 5: act(408); s.at = At::S84; return true;
                case 2: act(409); s.at = At::S60; return true;
                default: break;
            }
            return false;
        case At::S55:
            switch (e) {
                case 5: act(410); s.at = At::S53; return true;
                case 6: act(411); s.at = At::S67; return true;
                default: break;
            }
            return false;
        case At::S56:
            switch (e) {
                case 3: act(412); s.at = At::S87; return true;
                case 5: act(413); s.at = At::S34; return true;
                default: break;
            }
            return false;
        case At::S57:
            switch (e) {
                case 5: act(414); s.at = At::S63; return true;
                case 3: act(415); s.at = At::S9; return true;
                default: break;
            }
            return false;
        case At::S58:
            switch (e) {
                case 4: act(416); s.at = At::S85; return true;
                case 5: act(417); s.at = At::S24; return true;
                default: break;
            }
            return false;
        case At::S59:
            switch (e) {
                case 0: act(418); s.at = At::S79; return true;
                case 3: act(419); s.at = At::S16; return true;
                default: break;
            }
            return false;
        case At::S60:
            switch (e) {
                case 4: act(420); s.at = At::S7; return true;
                case 5: act(421); s.at = At::S21; return true;
                default: break;
            }
            return false;
        case At::S61:
            switch (e) {
                case 7: act(422); s.at = At::S60; return true;
                case 4: act(423); s.at = At::S95; return true;
                default: break;
            }
            return false;
        case At::S62:
            switch (e) {
                case 6: act(424); s.at = At::S27; return true;
                case 3: act(425); s.at = At::S0; return true;
                default: break;
            }
            return false;
        case At::S63:
            switch (e) {
                case 3: act(426); s.at = At::S1; return true;
                case 1: act(427); s.at = At::S78; return true;
                default: break;
            }
            return false;
        case At::S64:
            switch (e) {
                case 4: act(428); s.at = At::S50; return true;
                case 0: act(429); s.at = At::S98; return true;
                default: break;
            }
            return false;
        case At::S65:
            switch (e) {
                case 6: act(430); s.at = At::S70; return true;
                case 1: act(431); s.at = At::S6; return true;
                default: break;
            }
            return false;
        case At::S66:
            switch (e) {
                case 3: act(432); s.at = At::S85; return true;
                case 1: act(433); s.at = At::S77; return true;
                default: break;
            }
            return false;
        case At::S67:
            switch (e) {
                case 5: act(434); s.at = At::S71; return true;
                case 6: act(435); s.at = At::S99; return true;
                default: break;
            }
            return false;
        case At::S68:
            switch (e) {
                case 7: act(436); s.at = At::S56; return true;
                case 4: act(437); s.at = At::S3; return true;
                default: break;
            }
            return false;
        case At::S69:
            switch (e) {
                case 1: act(438); s.at = At::S89; return true;
                case 0: act(439); s.at = At::S76; return true;
                default: break;
            }
            return false;
        case At::S70:
            switch (e) {
                case 1: act(440); s.at = At::S71; return true;
                case 3: act(441); s.at = At::S32; return true;
                default: break;
            }
            return false;
        case At::S71:
            switch (e) {
                case 2: act(442); s.at = At::S46; return true;
                case 0: act(443); s.at = At::S10; return true;
                default: break;
            }
            return false;
        case At::S72:
            switch (e) {
                case 0: act(444); s.at = At::S44; return true;
                case 2: act(445); s.at = At::S9; return true;
                default: break;
            }
            return false;
        case At::S73:
            switch (e) {
                case 1: act(446); s.at = At::S58; return true;
                case 4: act(447); s.at = At::S48; return true;
                default: break;
            }
            return false;
        case At::S74:
            switch (e) {
                case 3: act(448); s.at = At::S39; return true;
                case 6: act(449); s.at = At::S49; return true;
                default: break;
            }
            return false;
        case At::S75:
            switch (e) {
                case 3: act(450); s.at = At::S62; return true;
                case 6: act(451); s.at = At::S51; return true;
                default: break;
            }
            return false;
        case At::S76:
            switch (e) {
                case 1: act(452); s.at = At::S14; return true;
                case 0: act(453); s.at = At::S79; return true;
                default: break;
            }
            return false;
        case At::S77:
            switch (e) {
                case 5: act(454); s.at = At::S55; return true;
                case 4: act(455); s.at = At::S53; return true;
                default: break;
            }
            return false;
        case At::S78:
            switch (e) {
                case 7: act(456); s.at = At::S80; return true;
                case 0: act(457); s.at = At::S25; return true;
                default: break;
            }
            return false;
        case At::S79:
            switch (e) {
                case 4: act(458); s.at = At::S61; return true;
                case 6: act(459); s.at = At::S54; return true;
                default: break;
            }
            return false;
        case At::S80:
            switch (e) {
                case 1: act(460); s.at = At::S71; return true;
                case 6: act(461); s.at = At::S21; return true;
                default: break;
            }
            return false;
        case At::S81:
            switch (e) {
                case 5: act(462); s.at = At::S20; return true;
                case 6: act(463); s.at = At::S22; return true;
                default: break;
            }
            return false;
        case At::S82:
            switch (e) {
                case 2: act(464); s.at = At::S63; return true;
                case 7: act(465); s.at = At::S43; return true;
                default: break;
            }
            return false;
        case At::S83:
            switch (e) {
                case 4: act(466); s.at = At::S0; return true;
                case 7: act(467); s.at = At::S90; return true;
                default: break;
            }
            return false;
        case At::S84:
            switch (e) {
                case 2: act(468); s.at = At::S82; return true;
                case 0: act(469); s.at = At::S39; return true;
                default: break;
            }
            return false;
        case At::S85:
            switch (e) {
                case 1: act(470); s.at = At::S14; return true;
                case 4: act(471); s.at = At::S62; return true;
                default: break;
            }
            return false;
        case At::S86:
            switch (e) {
                case 7: act(472); s.at = At::S9; return true;
                case 4: act(473); s.at = At::S66; return true;
                default: break;
            }
            return false;
        case At::S87:
            switch (e) {
                case 3: act(474); s.at = At::S37; return true;
                case 7: act(475); s.at = At::S45; return true;
                default: break;
            }
            return false;
        case At::S88:
            switch (e) {
                case 3: act(476); s.at = At::S23; return true;
                case 6: act(477); s.at = At::S80; return true;
                default: break;
            }
            return false;
        case At::S89:
            switch (e) {
                case 0: act(478); s.at = At::S6; return true;
                case 5: act(479); s.at = At::S78; return true;
                default: break;
            }
            return false;
        case At::S90:
            switch (e) {
                case 5: act(480); s.at = At::S59; return true;
                case 4: act(481); s.at = At::S72; return true;
                default: break;
            }
            return false;
        case At::S91:
            switch (e) {
                case 4: act(482); s.at = At::S64; return true;
                case 6: act(483); s.at = At::S56; return true;
                default: break;
            }
            return false;
        case At::S92:
            switch (e) {
                case 7: act(484); s.at = At::S18; return true;
                case 3: act(485); s.at = At::S32; return true;
                default: break;
            }
            return false;
        case At::S93:
            switch (e) {
                case 5: act(486); s.at = At::S43; return true;
                case 7: act(487); s.at = At::S17; return true;
                default: break;
            }
            return false;
        case At::S94:
            switch (e) {
                case 6: act(488); s.at = At::S77; return true;
                case 0: act(489); s.at = At::S18; return true;
                default: break;
            }
            return false;
        case At::S95:
            switch (e) {
                case 2: act(490); s.at = At::S47; return true;
                case 7: act(491); s.at = At::S25; return true;
                default: break;
            }
            return false;
        case At::S96:
            switch (e) {
                case 5: act(492); s.at = At::S79; return true;
                case 7: act(493); s.at = At::S11; return true;
                default: break;
            }
            return false;
        case At::S97:
            switch (e) {
                case 1: act(494); s.at = At::S82; return true;
                case 3: act(495); s.at = At::S22; return true;
                default: break;
            }
            return false;
        case At::S98:
            switch (e) {
                case 5: act(496); s.at = At::S47; return true;
                case 7: act(497); s.at = At::S41; return true;
                default: break;
            }
            return false;
        case At::S99:
            switch (e) {
                case 2: act(498); s.at = At::S2; return true;
                case 7: act(499); s.at = At::S77; return true;
                default: break;
            }
            return false;
    }
    return false;
}

}  // namespace by_hand_m4
