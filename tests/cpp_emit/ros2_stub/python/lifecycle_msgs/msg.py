# SPDX-License-Identifier: Apache-2.0
# Messages of lifecycle_msgs, for tests.


class Transition:
    TRANSITION_CONFIGURE = 1
    TRANSITION_ACTIVATE = 3
