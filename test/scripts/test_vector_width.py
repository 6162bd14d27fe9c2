# SPDX-License-Identifier: BSD-3-Clause
import importlib.util
import os
import unittest

PLACE = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'property', 'vector_width.py')
SPEC = importlib.util.spec_from_file_location('vector_width', PLACE)
vector_width = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(vector_width)

# Two loops in one: the inner one is packed, the outer one holds a packed addition of its own.
LISTING = '''
0000000000001000 <_ZN19hidwa_local_planner12_GLOBAL__N_111steady_rowsEPd.avx2.0>:
    1000:\tvaddpd %ymm0,%ymm1,%ymm2
    1004:\tvmulpd (%rax),%ymm0,%ymm1
    1008:\tvmulpd %xmm0,%xmm1,%xmm1
    100c:\tjne    1004 <_ZN19hidwa_local_planner12_GLOBAL__N_111steady_rowsEPd.avx2.0+0x4>
    1010:\tjmp    1000 <_ZN19hidwa_local_planner12_GLOBAL__N_111steady_rowsEPd.avx2.0>
    1014:\tret

0000000000002000 <_ZN19hidwa_local_planner12_GLOBAL__N_111steady_rowsEPd.isra.0.default.1>:
    2000:\tmulsd  (%rax),%xmm0
    2004:\taddpd  %xmm0,%xmm1
    2008:\tjne    2000 <_ZN19hidwa_local_planner12_GLOBAL__N_111steady_rowsEPd.isra.0.default.1>
    200c:\tret

0000000000003000 <_ZN19hidwa_local_planner7Planner5resetEv>:
    3000:\tmulpd  %xmm0,%xmm1
    3004:\tjne    3000 <_ZN19hidwa_local_planner7Planner5resetEv>
'''


class VectorWidth(unittest.TestCase):
    def faults(self, listing, name):
        return [fault for fault in vector_width.judge(listing, vector_width.PACKED) if fault.startswith(name)]

    def test_names(self):
        self.assertEqual(set(vector_width.functions(LISTING)),
                         {('steady_rows', 'avx2'), ('steady_rows', 'default')})

    def test_what_no_innermost_loop_holds_is_named(self):
        self.assertEqual(self.faults(LISTING, 'steady_rows'),
                         ['steady_rows, clone for avx2: no loop of it holds a packed addpd',
                          'steady_rows, clone for default: no loop of it holds a packed mulpd'])

    def test_half_the_width_is_not_enough(self):
        half = LISTING.replace('vmulpd (%rax),%ymm0,%ymm1', 'vmulpd (%rax),%xmm0,%xmm1')
        self.assertIn('avx2: no loop of it holds a packed mulpd, addpd', self.faults(half, 'steady_rows')[0])

    def test_all_is_well(self):
        well = LISTING.replace('vmulpd %xmm0,%xmm1,%xmm1', 'vaddpd %ymm0,%ymm1,%ymm1').replace('mulsd ', 'mulpd ')
        self.assertEqual(self.faults(well, 'steady_rows'), [])

    def test_functions_come_and_go(self):
        self.assertEqual(self.faults(LISTING, 'gather'), ['gather: the library holds no clone of it for avx2',
                                                          'gather: the library holds no clone of it for default'])
        self.assertIn('not listed here', self.faults(LISTING.replace('11steady_rows', '5novel'), 'novel')[0])


if __name__ == '__main__':
    unittest.main()
