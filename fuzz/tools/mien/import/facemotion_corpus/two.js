var m = {'a': {'version': 1, 'stiffness': 5, 'damping': 1, 'features': {'x': {'points': [{x: 1, y: 2}], 'weight': 0}}, 'muscleGroups': {}}, 'b': {}};
