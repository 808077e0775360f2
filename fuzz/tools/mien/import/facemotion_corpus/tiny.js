// A sample.
var tiny = {
    'version': 1.0,
    'stiffness': 20,  /* of springs */
    'damping': 8,
    'features': {
        'brow': {
            'points': [
                {x: 40, y: -34},
                {x: 112.5, y: -45},
            ],
            'weight': 1
        },
        mouth: {points: [{x: 0, y: 170}, {x: 60, y: 170}], weight: .5},
        'eyeball': {
            'type': 'circle', 'center': {x: 82, y: 0}, 'radius': 13, 'weight': 0.2,
            'upperChord': 0.7, "lowerChord": 0.94,
        }
    },
    'muscleGroups': {
        'zygomaticus': {
            'strength': 30, 'stroke': 50, 'origin': {x: 180, y: 50},
            'muscles': {
                'mouth:1': 1
                // 'mouth:0':0.1
            }
        },
        'orbicularis-oculi': {
            'strength': 20, 'stroke': 10, 'origin': {x: 80, y: +5},
            'muscles': {'eyeball:scale': 0.5, 'brow:0': 1e-1,}
        },
    },
    'recipes': {
        'joy': {'zygomaticus': 1, 'orbicularis-oculi': 0.8},
    }

};
