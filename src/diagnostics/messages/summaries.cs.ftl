### Co znamenají typy záznamů, česky. Anglicky je to v src/syntax/table.rs.

summary-undefined = `ID 0` deklaruje objekt, který smí být později jednou definován. Samotná `0` na místě ID je záznam VOID; uvozuje samostatný komentář.
summary-surface-of-revolution = Těleso: lomená čára z N bodů profilu otočená kolem osy y; x je vzdálenost od osy. Konce mimo osu uzavírají rovné kruhy, pokud není poslední bod totožný s prvním (prstenec). Vnitřek je určen pravidlem sudá–lichá na uzavřeném profilu. Válec o poloměru r a výšce h je `ID 1 2 r 0 r h`.
summary-coloured-surface-of-revolution = Jako typ 1, každý bod profilu má navíc barvu; mezi body se barva mění lineárně.
summary-plane = Plocha: všechny body, pro které platí ax + by + cz + d = 0. Nemá vnitřek ani orientaci.
summary-half-space = Těleso: všechny body, pro které platí ax + by + cz + d ≤ 0.
summary-rectangle = Plocha: obdélník v rovině z = 0, rovnoběžný s osami.
summary-triangle = Plocha: rovinný trojúhelník.
summary-triangle-with-normal = Plocha: trojúhelník s jednou normálou pro stínování, společnou pro celou plochu.
summary-triangle-with-vertex-normals = Plocha: trojúhelník s normálou pro stínování v každém vrcholu; mezi nimi se interpoluje a znovu normuje.
summary-sphere-at-origin = Těleso: koule s tímto poloměrem a středem v počátku.
summary-ellipsoid = Těleso: elipsoid se středem v počátku a poloosami ve směru souřadnicových os.
summary-sphere = Těleso: koule s tímto středem a poloměrem.
summary-box = Těleso: kvádr mezi dvěma rohy, se stěnami kolmými na souřadnicové osy.
summary-geodesic-sphere = Těleso: dvacetistěn s vrcholy (0, ±1, ±φ) a jejich cyklickými záměnami; každá stěna se n-krát rozdělí na čtyři a nové vrcholy se vysunou na kouli: 20·4ⁿ rovných plošek.
summary-torus = Těleso: torus (anuloid) kolem osy y. Trubka smí být širší než R; vnitřek je určen pravidlem sudá–lichá.
summary-quadric = Těleso: všechny body, pro které platí xᵀQx ≤ 0, kde x = (x, y, z, 1). Z matice Q záleží jen na symetrické části.
summary-cone = Těleso: kužel s vrcholem v počátku a osou y; podstava má poloměr r a leží ve výšce y = h.
summary-double-cone = Těleso: dva kužely se společným vrcholem v počátku; podstavy mají poloměr r a leží ve výškách y = ±h.
summary-parabolic-cylinder = Těleso: (x/a)² − y ≤ 0, podél osy z.
summary-hyperbolic-cylinder = Těleso: (x/a)² − (y/b)² − 1 ≤ 0, podél osy z.
summary-hyperboloid = Těleso kolem osy y; jednodílný: (x/a)² − (y/b)² + (z/c)² − 1 ≤ 0, dvojdílný: (x/a)² − (y/b)² + (z/c)² + 1 ≤ 0.
summary-hyperbolic-paraboloid = Těleso: (x/a)² − (z/b)² − y ≤ 0.
summary-translate = Posune objekt, bodové světlo nebo kameru s tímto ID.
summary-rotate = Otočí objekt, bodové světlo nebo kameru s tímto ID kolem souřadnicové osy.
summary-scale = Změní měřítko objektu, bodového světla nebo kamery s tímto ID vzhledem k počátku; záporný koeficient zrcadlí.
summary-rotation-matrix = Otočí objekt, bodové světlo nebo kameru s tímto ID maticí 4×4, zapsanou po řádcích; násobí se jí sloupcové vektory.
summary-projection-matrix = Dá kameře s tímto ID vlastní projekci místo fovy: ořez = P · pohled · x, s ořezovou krychlí jako v OpenGL. Nové ID definuje kameru v počátku, která hledí ve směru −z.
summary-union = A := B ∪ C. Každá část si ponechá své vlastnosti; bod, který leží v obou operandech, patří prvnímu.
summary-intersection = A := B ∩ C. Každá část hranice si ponechá vlastnosti tvaru, ze kterého pochází.
summary-difference = A := B − C: C se odečte od B. Celá hranice, i plochy řezu, má vlastnosti B.
summary-complement = A := −B, vše vně B.
summary-copy = A := B v té podobě, jakou má v tomto místě; kopie a originál se pak mění nezávisle.
summary-optics = Koeficienty difuzního odrazu, zrcadlového odrazu a propustnosti, ve všech kanálech stejné.
summary-optics-rgb = Koeficienty difuzního odrazu, zrcadlového odrazu a propustnosti, pro každý kanál zvlášť.
summary-refractive-index = Index lomu, pro každý kanál jeden; různé hodnoty světlo rozloží na barvy.
summary-assign = Přiřadí objektu s tímto ID texturu nebo barvu a optickou vlastnost; 0 znamená výchozí hodnoty.
summary-image-texture = Obrázek nanesený podle souřadnic na povrchu (u, v); opakuje se a čte se jako sRGB.
summary-solid-texture = Krychle dvou střídavých barev v souřadnicích, které má objekt v okamžiku přiřazení.
summary-checkerboard = N × M polí podle souřadnic na povrchu; barva c1 je tam, kde je ⌊uN⌋ + ⌊vM⌋ sudé.
summary-ambient-light = Světlo, které přichází odevšad na každý povrch; více takových světel se sčítá.
summary-point-light = Světlo v počátku, dokud ho neposune transformace; se vzdáleností neslábne.
summary-camera = Poloha, směr pohledu a vektor „nahoru“ (oba libovolné délky) a svislý zorný úhel. Směr není bod: má-li se kamera dívat na nějaký bod, napište tento bod minus polohu.
summary-mono-camera = Vybere kameru, kterou se pořídí obrázek; platí poslední výběr.
summary-stereo-camera = Vybere dvojici kamer pro stereoskopický obrázek; platí poslední výběr.
summary-bounding-box = Slibuje, že objekt s tímto ID leží v tomto kvádru. Obrázek nikdy nemění.
summary-bounding-sphere = Slibuje, že objekt s tímto ID leží v této kouli. Obrázek nikdy nemění.
summary-colour = Lineární červená, zelená a modrá složka od 0 do 1. Záznam s ID objektu nebo světla nastavuje jeho barvu.
summary-render = Co se vykreslí, vždy s ID 1: objekt, pozadí a kvádr, mimo který není nic vidět.
