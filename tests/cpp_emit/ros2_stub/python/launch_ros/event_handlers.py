# SPDX-License-Identifier: Apache-2.0
# Event handlers of launch_ros, for tests.


class OnStateTransition:
    def __init__(self, *, entities, target_lifecycle_node=None, transition=None, start_state=None, goal_state=None,
                 handle_once=False):
        assert transition is None or (start_state is None and goal_state is None)
        self.entities, self.node = entities, target_lifecycle_node
        self.start_state, self.goal_state, self.handle_once = start_state, goal_state, handle_once
