# SPDX-License-Identifier: Apache-2.0
# Events of lifecycle nodes, for tests.


class ChangeState:
    def __init__(self, *, lifecycle_node_matcher, transition_id):
        self.matches, self.transition_id = lifecycle_node_matcher, transition_id
