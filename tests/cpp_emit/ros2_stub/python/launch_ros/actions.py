# SPDX-License-Identifier: Apache-2.0
# Actions of launch_ros, for tests.
from launch.actions import Action


class LifecycleNode(Action):
    def __init__(self, *, name, namespace, package, executable, parameters=None, output=None, condition=None):
        super().__init__(condition)
        self.name, self.namespace, self.package, self.executable = name, namespace, package, executable
        self.parameters, self.output = parameters, output
