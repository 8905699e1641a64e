# SPDX-License-Identifier: Apache-2.0
# Conditions of launch, for tests.


class IfCondition:
    def __init__(self, predicate_expression):
        self.predicate_expression = predicate_expression
