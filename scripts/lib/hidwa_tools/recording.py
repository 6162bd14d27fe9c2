# SPDX-License-Identifier: BSD-3-Clause
"""What a drive's bag holds, for scripts/demo and for the launch files' argument record. Standard library only, so that
a robot can have it."""
import os
import re

# About the drive to one goal, by names below move_base's namespace. Topics that nobody publishes cost nothing.
HOST = 'move_base/'
JUDGED = ('map', HOST + 'goal', HOST + 'cancel', HOST + 'result', HOST + 'status', HOST + 'recovery_status',
          'cmd_vel', 'odom', 'amcl_pose', 'joy', 'hand_pose')
# Of the local planner, below its own name.
PLANNED = ('cycle', 'operator_state', 'mode', 'set_mode', 'take_control', 'stop', 'global_plan', 'local_plan',
           'parameter_updates')
SHARED = ('/tf', '/tf_static', '/diagnostics', '/rosout')
# What the simulated robot says of itself.
SIMULATED = ('demo_info', 'ground_truth', 'moving_obstacles_truth', 'regions', 'contacts', 'contacts_moving', 'contacts_at_rest',
             'regions_crossed')
# What was seen, which a simulation can compute again, and the costmaps' parameters.
SEEN = ('scan', HOST + 'local_costmap/costmap', HOST + 'local_costmap/costmap_updates', HOST + 'local_costmap/footprint',
        HOST + 'local_costmap/parameter_updates', HOST + 'global_costmap/parameter_updates', HOST + 'parameter_updates')

DEFAULT_PLANNER = 'HIDWAPlannerROS'


def plugin_name(lookup):
    """The name by which a host knows a plugin, and below which the plugin's topics and parameters lie: what comes after the
    last / or :: (pluginlib, ClassLoader::getName)."""
    return re.split('[/:]', lookup)[-1]


def recorded_topics(global_planner, planner=DEFAULT_PLANNER, seen=False, resolve=lambda name: '/' + name.lstrip('/')):
    """Names of the topics to record, without doublets; the planners are given by their lookup names. `resolve` makes a name
    relative to move_base's namespace a full one. The demo's are without what was seen: that can be computed again and
    would fill the bag."""
    names = [*SIMULATED, *JUDGED, f'{HOST}{plugin_name(global_planner)}/plan',
             *(f'{HOST}{plugin_name(planner)}/{name}' for name in PLANNED), *SHARED]
    return list(dict.fromkeys(resolve(name) for name in [*names, *(SEEN if seen else ())]))


def operator_topics(parameters):
    """Topics that the planner listens to by its parameters; rumble_topic is one that it sends."""
    return [topic for name, topic in parameters.items()
            if name.endswith('_topic') and name != 'rumble_topic' and isinstance(topic, str) and topic]


def stick_of(parameters):
    """The steering axis of a planner with these parameters: {'axis', 'sign', 'dead_zone'}. Until 2026-11-29 the sign was a
    parameter of its own."""
    index, *reversed_ = str(parameters.get('axis_angular', 0)).split()
    return {'axis': int(index), 'sign': -1 if reversed_ else parameters.get('axis_angular_sign', 1),
            'dead_zone': parameters.get('dead_zone', 0.1)}


def observed_topics(costmap):
    """(laser scans, other sources) that a costmap's layers watch, by the costmap's parameters."""
    scans, others = [], []
    for layer in costmap.values():
        sources = layer.get('observation_sources', '') if isinstance(layer, dict) else ''
        for name in str(sources).split():
            source = layer.get(name, {})
            (scans if source.get('data_type') == 'LaserScan' else others).append(source.get('topic', name))
    return scans, others


def bag_path(text):
    """The full path of the bag to write. ValueError with a remedy where it cannot be, or would replace something."""
    path = os.path.expanduser(text)
    if not os.path.isabs(path):
        raise ValueError(f"record:={text} is relative, and nodes run elsewhere: give a full path, record:=$PWD/{text}")
    if os.path.isdir(path):
        raise ValueError(f'record:={text} is a folder: name a file in it')
    path = path if path.endswith('.bag') else path + '.bag'
    folder = os.path.dirname(path)
    if not os.path.isdir(folder):
        raise ValueError(f'record:={text}: there is no folder {folder}; make it first')
    if not os.access(folder, os.W_OK):
        raise ValueError(f'record:={text}: {folder} cannot be written to; give another folder')
    for there in (path, path + '.active'):
        if os.path.exists(there):
            raise ValueError(f'record:={text}: {there} exists and is not overwritten; give another name or move it away')
    return path
