"""Figures of the benchmarks: read, put into a table, compared.

A figure is a dict: name, value, unit, better ("less" or "more"), and where
there is one: baseline (its name), baseline_value (measured in the same run),
ratio, goal. The ratio is value / baseline_value. A goal is one of the ratio, or
of the value where there is no baseline.
"""

import json
import re

# Relative change below which two runs do not differ, by what a figure's name
# begins with; the first that fits. Measured on a machine that others use too.
NOISE = [
    ('lateness of a loop', 1.00),
    ('live cell', 0.50),
    ('memory', 0.05),
    ('log', 0.02),
    ('growth', 0.50),
    ('', 0.15),
]


def noise_of(name):
    return next(margin for start, margin in NOISE if name.startswith(start))


def with_ratio(figure):
    if figure.get('baseline_value'):
        figure['ratio'] = figure['value'] / figure['baseline_value']
    return figure


def figures_of_lines(text):
    """The figures among the lines that a program has printed."""
    figures = []
    for line in text.splitlines():
        if not line.startswith('{"figure"'):
            continue
        figure = json.loads(line)
        figure['name'] = figure.pop('figure')
        figures.append(with_ratio(figure))
    return figures


def figures_of_growth(rows):
    """Those of the table of `cell eval growth`: of each series the larger sizes,
    with the smallest one as the baseline."""
    figures = []
    first = {}
    for row in rows:
        name = f"growth: {row['series']}, {row['size']} {row['grows']}"
        milliseconds = 1000 * float(row['seconds'])
        if row['series'] not in first:
            first[row['series']] = name, milliseconds
            continue
        baseline, value = first[row['series']]
        figures.append(with_ratio({
            'name': name, 'value': milliseconds, 'unit': 'ms', 'better': 'less',
            'baseline': baseline, 'baseline_value': value}))
    return figures


def cost_of(benchmark):
    """Name and time of a run of Google Benchmark; of an item where it counts
    items."""
    name = re.sub(r'/(manual_time|real_time)$', '', benchmark['name'])
    if 'items_per_second' in benchmark:
        return name, 1e6 / benchmark['items_per_second'], 'us'
    return name, benchmark['cpu_time'], benchmark['time_unit']


def figures_of_google(text, baselines):
    """Those of Google Benchmark's JSON. `baselines`: pairs of a pattern and the
    name of the benchmark that is the baseline of those whose name it fits; the
    first counts. The baselines themselves are no figures."""
    costs = {}
    for benchmark in json.loads(text)['benchmarks']:
        name, cost, unit = cost_of(benchmark)
        costs[name] = (cost, unit)
    figures = []
    used = set()
    for name, (cost, unit) in costs.items():
        figure = {'name': name, 'value': cost, 'unit': unit, 'better': 'less'}
        for pattern, baseline in baselines:
            match = re.fullmatch(pattern, name)
            if match:
                figure['baseline'] = match.expand(baseline)
                used.add(figure['baseline'])
                figure['baseline_value'] = in_unit(
                    *costs[figure['baseline']], unit)
                break
        figures.append(with_ratio(figure))
    return [figure for figure in figures if figure['name'] not in used]


def in_unit(value, unit, wanted):
    seconds = {'ns': 1e-9, 'us': 1e-6, 'ms': 1e-3, 's': 1}
    return value * seconds[unit] / seconds[wanted]


def measure_of(figure):
    """What is compared between runs and with the goal: ratios travel."""
    return figure.get('ratio', figure['value'])


def meets_goal(figure):
    """Or None without a goal."""
    if 'goal' not in figure:
        return None
    if figure['better'] == 'more':
        return measure_of(figure) >= figure['goal']
    return measure_of(figure) <= figure['goal']


def number(value):
    return f'{value:.4g}' if abs(value) < 1e4 else f'{value:.0f}'


def table(figures):
    rows = [('figure', 'value', 'unit', 'baseline', 'its value', 'ratio',
             'goal')]
    for figure in figures:
        goal = ''
        if 'goal' in figure:
            sign = '>=' if figure['better'] == 'more' else '<='
            goal = f"{sign} {number(figure['goal'])}"
            goal += '' if meets_goal(figure) else '  MISSED'
        rows.append((figure['name'], number(figure['value']), figure['unit'],
                     figure.get('baseline', ''),
                     number(figure['baseline_value'])
                     if 'baseline_value' in figure else '',
                     f"{figure['ratio']:.3g}" if 'ratio' in figure else '',
                     goal))
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    is_number = (False, True, False, False, True, True, False)
    lines = []
    for row in rows:
        cells = [cell.rjust(width) if right else cell.ljust(width)
                 for cell, width, right in zip(row, widths, is_number)]
        lines.append('  '.join(cells).rstrip())
    return '\n'.join(lines)


def compare(old, new):
    """Lines on what differs by more than the noise, and whether anything is
    worse. Figures that only one of the two runs has are not compared."""
    before = {figure['name']: figure for figure in old}
    lines, is_worse = [], False
    for figure in new:
        other = before.get(figure['name'])
        if other is None:
            continue
        a, b = measure_of(other), measure_of(figure)
        margin = noise_of(figure['name'])
        grows = b > a * (1 + margin)
        shrinks = a > b * (1 + margin)
        if not grows and not shrinks:
            continue
        bad = grows if figure['better'] == 'less' else shrinks
        is_worse |= bad
        what = 'ratio' if 'ratio' in figure else figure['unit']
        lines.append(f"{'WORSE ' if bad else 'better'}  {figure['name']}: "
                     f"{number(a)} -> {number(b)} ({what}; noise "
                     f"{margin:.0%})")
    num_common = sum(figure['name'] in before for figure in new)
    if not lines:
        lines = [f'no difference beyond the noise in {num_common} figures']
    return lines, is_worse
