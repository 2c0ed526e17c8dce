W323 = zorný úhel { $angle } stupně vypadá jako { $degrees }° v radiánech
    .label = úhel se píše ve stupních
    .note = obrázek tak zachytí jen nepatrnou část scény
    .fix = napsat { $degrees }
