def model_sketch(results, fields):
    return []
