# SPDX-License-Identifier: Apache-2.0
# Actions of launch, for tests.


class Action:
    def __init__(self, condition=None):
        self.condition = condition


class DeclareLaunchArgument(Action):
    def __init__(self, name, *, default_value=None, description=None, condition=None):
        super().__init__(condition)
        self.name, self.default_value, self.description = name, default_value, description


class EmitEvent(Action):
    def __init__(self, *, event, condition=None):
        super().__init__(condition)
        self.event = event


class RegisterEventHandler(Action):
    def __init__(self, event_handler, condition=None):
        super().__init__(condition)
        self.event_handler = event_handler
