# As much of the package launch as generated launch files use, for tests: what is described, as objects.


class LaunchDescription:
    def __init__(self, entities):
        self.entities = entities
