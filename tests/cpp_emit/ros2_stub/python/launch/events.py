# SPDX-License-Identifier: Apache-2.0
# Events of launch, for tests.


def matches_action(target_action):
    return lambda action: action is target_action
