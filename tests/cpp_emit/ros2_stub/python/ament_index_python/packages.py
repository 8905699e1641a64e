# SPDX-License-Identifier: Apache-2.0
# The installation folders of packages, for tests.


def get_package_share_directory(package_name):
    return '/share/' + package_name
