# SPDX-License-Identifier: Apache-2.0
# The parts of the package launch that generated launch files use, for tests: descriptions as objects.


class LaunchDescription:
    def __init__(self, entities):
        self.entities = entities
